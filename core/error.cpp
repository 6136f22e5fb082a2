#include "core/error.h"

namespace brume {
namespace {

// Control characters of a hostile file name or value must not break the promise of one line.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return text;
}

}  // namespace

InputError::InputError(const std::filesystem::path& file, const std::string& place,
                       const std::string& message)
    : std::runtime_error(
          one_line(file.string() + ": " + (place.empty() ? "" : place + ": ") + message)) {}

}  // namespace brume
