#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace brume {

// A map of directions around a point onto [-1, 1]^2: perspective towards a ball, or octahedral
// (all directions) when the point is inside the ball or close to it. Tables over it have `cells`
// cells per axis and a border of one cell on all sides for linear interpolation.
struct DirectionMap {
  int cells = 0;
  bool octahedral = true;
  glm::vec3 right{1, 0, 0}, up{0, 1, 0}, axis{0, 0, 1};  // of the perspective map
  float scale = 1.0f;                                    // 1 / tan(half angle of the cone)

  static DirectionMap all(int cells) { return {.cells = cells}; }

  static DirectionMap towards(const glm::dvec3& origin, const glm::dvec3& middle, double radius,
                              int cells) {
    DirectionMap map = all(cells);
    const double distance = glm::length(middle - origin);
    // Up to 53 degrees to each side a perspective map wastes less than an octahedral one.
    map.octahedral = distance < 1.25 * radius;
    if (map.octahedral) return map;
    map.axis = glm::vec3((middle - origin) / distance);
    const glm::vec3 other = std::abs(map.axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    map.right = glm::normalize(glm::cross(map.axis, other));
    map.up = glm::cross(map.right, map.axis);
    map.scale = static_cast<float>(std::sqrt(distance * distance - radius * radius) / radius);
    return map;
  }

  [[nodiscard]] int row() const { return cells + 2; }

  // The unit direction of the middle of a cell; -1 and `cells` are the border.
  [[nodiscard]] glm::dvec3 direction(int x, int y) const {
    double u = (2.0 * x + 1.0) / cells - 1.0;
    double v = (2.0 * y + 1.0) / cells - 1.0;
    if (!octahedral) {
      return glm::normalize(static_cast<double>(scale) * glm::dvec3(axis) + u * glm::dvec3(right) +
                            v * glm::dvec3(up));
    }
    // Over the border of the map the octahedron folds back.
    if (std::abs(u) > 1.0) {
      u = std::copysign(2.0, u) - u;
      v = -v;
    }
    if (std::abs(v) > 1.0) {
      v = std::copysign(2.0, v) - v;
      u = -u;
    }
    glm::dvec3 d(u, v, 1.0 - std::abs(u) - std::abs(v));
    if (d.z < 0.0) {
      d.x = std::copysign(1.0 - std::abs(v), u);
      d.y = std::copysign(1.0 - std::abs(u), v);
    }
    return glm::normalize(d);
  }

  bool operator==(const DirectionMap&) const = default;
};

}  // namespace brume
