#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace brume {

// An orthonormal basis (u, v, axis), right-handed, for a unit vector `axis`.
struct Basis {
  glm::dvec3 u;
  glm::dvec3 v;
};
inline Basis make_basis(const glm::dvec3& axis) {
  const glm::dvec3 other = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(other, axis));
  return {u, glm::cross(axis, u)};
}

}  // namespace brume
