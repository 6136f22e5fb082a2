#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace brume {

// A vector of any length as a unit one, without overflow or underflow of its square; `absent` for
// length 0, which keyframes may pass.
inline glm::dvec3 unit_direction(const glm::dvec3& v, const glm::dvec3& absent) {
  const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return size > 0.0 ? glm::normalize(v / size) : absent;
}

}  // namespace brume
