#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace brume {

// Two unit vectors that make a right-handed frame (u, v, axis) with the unit vector `axis`.
struct Across {
  glm::dvec3 u;
  glm::dvec3 v;
};
inline Across across(const glm::dvec3& axis) {
  const glm::dvec3 other = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(other, axis));
  return {u, glm::cross(axis, u)};
}

}  // namespace brume
