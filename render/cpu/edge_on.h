#pragma once

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace brume {

// A triangle whose plane the eye lies in shows nothing but a line. Where single precision has it is
// chance, so it is invisible, to all that looks from there.

// How far the eye may be from such a plane: a few roundings of float [u]. `eye` is relative to the
// middle of all surfaces, which lie within `radius` of it.
inline double edge_on_height(const glm::dvec3& eye, double radius) {
  return 1e-6 * std::max(glm::length(eye), radius);
}

// Whether a triangle is seen so; one without an area always is.
inline bool is_edge_on(const std::array<glm::vec3, 3>& corners, const glm::dvec3& eye,
                       double height) {
  const glm::dvec3 first(corners[0]);
  const glm::dvec3 normal =
      glm::cross(glm::dvec3(corners[1]) - first, glm::dvec3(corners[2]) - first);
  const double above = glm::dot(normal, eye - first);
  return above * above <= height * height * glm::dot(normal, normal);
}

}  // namespace brume
