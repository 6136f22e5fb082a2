#pragma once

#include <string>

namespace brume {

// A text as UTF-8 without a byte order mark: from UTF-16 of either byte order where it begins with
// such a mark, else as it is.
std::string as_utf8(std::string bytes);

}  // namespace brume
