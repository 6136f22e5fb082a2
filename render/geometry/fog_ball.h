#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/math/infinity.h"

namespace brume {

// Where homogeneous fog is: everywhere, or in a ball.
struct FogBall {
  glm::dvec3 center{0.0};
  double radius = infinity;  // [u]

  [[nodiscard]] bool is_endless() const { return radius == infinity; }

  // Length of a ray from x in the unit direction w within it [u].
  [[nodiscard]] double length(const glm::dvec3& x, const glm::dvec3& w) const {
    if (is_endless()) return infinity;
    const glm::dvec3 q = x - center;
    const double along = glm::dot(q, w);
    const double square = along * along + radius * radius - glm::dot(q, q);
    if (!(square > 0.0)) return 0.0;
    const double half = std::sqrt(square);  // of the line's chord
    return std::clamp(half - along, 0.0, 2.0 * half);
  }

  bool operator==(const FogBall&) const = default;
};

// How far around a place fog of density b0 > 0 [1/u] scatters light so that it comes back there:
// some mean free paths (in dense fog alone, with one 15% of the light of all orders is missing), or
// to its end [u].
inline double scattering_reach(double b0, const FogBall& ball, double mean_free_paths = 4.0) {
  return std::min(mean_free_paths / b0, ball.radius);
}

}  // namespace brume
