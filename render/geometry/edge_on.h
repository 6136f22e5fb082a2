#pragma once

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace brume {

// Triangles seen edge-on: in single precision it is arbitrary whether rays hit them, so they are
// invisible to all methods.

// A few float roundings, relative.
constexpr double edge_on_rounding = 1e-6;

// Maximum distance of the eye from the plane of such a triangle [u]. `eye`
// is relative to the center of all surfaces, which lie within `radius` of it.
inline double edge_on_height(const glm::dvec3& eye, double radius) {
  return edge_on_rounding * std::max(glm::length(eye), radius);
}

// Whether a triangle is seen edge-on; always true for degenerate ones.
inline bool is_edge_on(const std::array<glm::vec3, 3>& corners, const glm::dvec3& eye,
                       double height) {
  const glm::dvec3 first(corners[0]);
  const glm::dvec3 normal =
      glm::cross(glm::dvec3(corners[1]) - first, glm::dvec3(corners[2]) - first);
  const double above = glm::dot(normal, eye - first);
  return above * above <= height * height * glm::dot(normal, normal);
}

}  // namespace brume
