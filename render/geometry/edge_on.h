#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "render/geometry/rounding.h"

namespace brume {

// Triangles seen edge-on: in single precision it is arbitrary whether rays hit them, so they are
// invisible to all methods.

// Below that of shadow rays' origins, or rays from surfaces would miss their neighbours.
constexpr double edge_on_rounding = 0.2 * position_rounding;

// An eye that is off a plane by this share of the coordinates is meant to lie in it.
constexpr double edge_on_share = 4e-8;

// Whether a triangle is seen edge-on; always true for degenerate ones. `eye` and corners are
// relative to the same point.
inline bool is_edge_on(const std::array<glm::vec3, 3>& corners, const glm::dvec3& eye) {
  const glm::dvec3 first(corners[0]);
  const glm::dvec3 normal =
      glm::cross(glm::dvec3(corners[1]) - first, glm::dvec3(corners[2]) - first);
  const glm::dvec3 sizes = glm::max(coordinate_sizes(corners), glm::abs(eye));
  return std::abs(glm::dot(normal, eye - first)) <=
         edge_on_rounding * glm::dot(glm::abs(normal), sizes) +
             edge_on_share * max_component(sizes) * glm::length(normal);
}

// The same as seen along parallel rays.
inline bool is_along(const std::array<glm::vec3, 3>& corners, const glm::dvec3& direction) {
  const glm::dvec3 first(corners[0]);
  const glm::dvec3 normal =
      glm::cross(glm::dvec3(corners[1]) - first, glm::dvec3(corners[2]) - first);
  const glm::dvec3 sizes = glm::abs(direction);
  return std::abs(glm::dot(normal, direction)) <=
         edge_on_rounding * glm::dot(glm::abs(normal), sizes) +
             edge_on_share * max_component(sizes) * glm::length(normal);
}

}  // namespace brume
