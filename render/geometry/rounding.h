#pragma once

#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/math/max_component.h"

namespace brume {

// The uncertainty of positions near surfaces in single precision. Coordinates round one by one, so
// that a floor of any extent has as exact a height as a small one (Waechter and Binder, "A Fast and
// Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, 2019).

// A few float roundings, relative.
constexpr double position_rounding = 1e-6;

// How far a position may be off [u], relative to what it is stored from.
inline double rounding_at(const glm::dvec3& position) {
  return position_rounding * max_component(glm::abs(position));
}

// The greatest size of each coordinate of a triangle.
inline glm::dvec3 coordinate_sizes(const std::array<glm::vec3, 3>& corners) {
  return glm::max(glm::abs(corners[0]), glm::max(glm::abs(corners[1]), glm::abs(corners[2])));
}

// How far points that are computed on a plane may lie off it [u], by its unit normal and the sizes
// of the coordinates that they are computed from.
inline double off_plane_rounding(const glm::dvec3& normal, const glm::dvec3& sizes) {
  return position_rounding *
         (glm::dot(glm::abs(normal), sizes) + position_rounding * max_component(sizes));
}

}  // namespace brume
