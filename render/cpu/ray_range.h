#pragma once

#include <algorithm>
#include <limits>

namespace brume {

// Optical depth of homogeneous fog past which its light is left out: exp(-12) = 6e-6.
constexpr double fog_end = 12.0;

// A part of a ray [u], empty until something is added.
struct RayRange {
  double begin = std::numeric_limits<double>::infinity();
  double end = 0.0;

  [[nodiscard]] bool empty() const { return !(begin < end); }
  void add(double from, double to) {
    begin = std::min(begin, from);
    end = std::max(end, to);
  }
  // Cuts it to [0, length].
  void clip(double length) {
    begin = std::clamp(begin, 0.0, length);
    end = std::clamp(end, 0.0, length);
  }
};

}  // namespace brume
