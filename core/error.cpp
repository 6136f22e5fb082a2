#include "brume/error.h"

#include "core/printable_text.h"

namespace brume {

InputError::InputError(const std::filesystem::path& file, const std::string& place,
                       const std::string& message)
    : std::runtime_error(
          printable(file.string() + ": " + (place.empty() ? "" : place + ": ") + message)) {}

DomainError::DomainError(const std::string& place, const std::string& message)
    : std::domain_error(printable(place + ": " + message)) {}

}  // namespace brume
