#pragma once

#include <string>
#include <utility>
#include <vector>

#include "brume/export.h"

namespace brume {

// "1.2.3", a semantic version: while it begins with 0, a new minor version may change interfaces.
BRUME_EXPORT const char* version();

// The build and the machine: names and versions of libraries, the compiler, and the vector
// instructions in use.
BRUME_EXPORT std::vector<std::pair<std::string, std::string>> build_information();

}  // namespace brume
