#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace brume {

// An error in the user's input: an unreadable file, a value outside its domain. what() is one
// printable line, "FILE: PLACE: MESSAGE" (core/printable_text.h). `place` is the position in the
// file (JSON path, line, byte) and may be empty.
class InputError : public std::runtime_error {
 public:
  InputError(const std::filesystem::path& file, const std::string& place,
             const std::string& message);
};

}  // namespace brume
