#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace brume {

// Twice the area of a triangle along its normal by its winding.
template <class Point>
glm::dvec3 area_normal(const std::vector<Point>& points, const glm::uvec3& triangle) {
  const glm::dvec3 a(points[triangle.x]);
  return glm::cross(glm::dvec3(points[triangle.y]) - a, glm::dvec3(points[triangle.z]) - a);
}

}  // namespace brume
