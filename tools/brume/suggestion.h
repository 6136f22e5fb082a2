#pragma once

#include <span>
#include <string>
#include <string_view>

namespace brume {

// "; did you mean NAME?" for the name nearest to a mistyped word, "" if none is near.
std::string suggestion(std::string_view word, std::span<const std::string> names);

}  // namespace brume
