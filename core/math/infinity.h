#pragma once

#include <limits>

namespace brume {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace brume
