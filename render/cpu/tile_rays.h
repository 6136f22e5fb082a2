#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace brume {

// The view rays of the pixels of one tile, and what every airlight method makes of them.
struct TileRays {
  glm::dvec3 eye{0.0};
  std::span<const glm::dvec3> directions;  // unit
  std::span<const double> lengths;         // to the surface [u], or +inf
};

struct TileAirlight {
  std::span<glm::vec3> airlight;  // RGB radiance
  std::span<double> depths;       // T(v, p), b0 included; +inf possible
};

}  // namespace brume
