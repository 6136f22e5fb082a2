#pragma once

#include <numbers>

namespace brume {

// Turns by this angle spread directions evenly around an axis [rad].
inline constexpr double golden_angle = std::numbers::pi * (3.0 - 2.2360679774997896964);

}  // namespace brume
