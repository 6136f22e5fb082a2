#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace brume {

// Ends of the view rays.
struct RayEnds {
  // For rays that hit no surface [u].
  double open = std::numeric_limits<double>::infinity();
  // Distance to the surface per pixel, +inf for none [u]; empty: use the depth layer.
  std::span<const double> surfaces;

  // `depth`: that layer.
  [[nodiscard]] double distance(std::span<const float> depth, std::size_t pixel) const {
    const double surface = surfaces.empty() ? static_cast<double>(depth[pixel]) : surfaces[pixel];
    return std::isfinite(surface) ? surface : open;
  }
};

}  // namespace brume
