#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace brume {

// Twice the area of a triangle along its normal by its winding.
template <class Point>
glm::dvec3 area_normal(const std::vector<Point>& points, const glm::uvec3& triangle) {
  const glm::dvec3 a(points[triangle.x]);
  return glm::cross(glm::dvec3(points[triangle.y]) - a, glm::dvec3(points[triangle.z]) - a);
}

// The unit vector along v, or 0 where it has no direction.
glm::dvec3 direction_or_zero(const glm::dvec3& v);

// A normal moved so that it stays perpendicular, unit; 0 where it has no direction.
glm::dvec3 moved_normal(const glm::dmat3& to_world, const glm::dvec3& normal);

}  // namespace brume
