#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace brume {

// A mistake in what the user gave us: a file that cannot be read, a value outside its domain.
// what() is one line, "FILE: PLACE: MESSAGE", printable (core/printable_text.h) and fit to be shown
// as it is. `place` says where in the file (a JSON path, a line, a byte) and may be empty.
class InputError : public std::runtime_error {
 public:
  InputError(const std::filesystem::path& file, const std::string& place,
             const std::string& message);
};

}  // namespace brume
