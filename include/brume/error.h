#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "brume/export.h"

namespace brume {

// An error in the user's input: an unreadable file, a value outside its domain. what() is one
// printable line, "FILE: PLACE: MESSAGE" (core/printable_text.h). `place` is the position in the
// file (JSON path, line, byte) and may be empty.
class BRUME_EXPORT InputError : public std::runtime_error {
 public:
  InputError(const std::filesystem::path& file, const std::string& place,
             const std::string& message);
};

// A value outside its domain in a scene or a request that a program made. what() is one printable
// line, "PLACE: found VALUE; allowed: DOMAIN", with the place as in a scene file:
// "lights[2].position".
class BRUME_EXPORT DomainError : public std::domain_error {
 public:
  DomainError(const std::string& place, const std::string& message);
};

}  // namespace brume
