#pragma once

#include <algorithm>
#include <limits>

namespace brume {

// Homogeneous fog beyond this optical depth is ignored: exp(-12) = 6e-6.
constexpr double opaque_fog_depth = 12.0;

// Distances beyond this are clamped to it where float computes with them [u].
constexpr double endless = 1e30;

// An interval of a ray [u], initially empty.
struct RayRange {
  double begin = std::numeric_limits<double>::infinity();
  double end = 0.0;

  [[nodiscard]] bool empty() const { return !(begin < end); }
  void add(double first, double last) {
    begin = std::min(begin, first);
    end = std::max(end, last);
  }
  // Clamps it to [0, length].
  void clip(double length) {
    begin = std::clamp(begin, 0.0, length);
    end = std::clamp(end, 0.0, length);
  }
};

}  // namespace brume
