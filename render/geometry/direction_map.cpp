#include "render/geometry/direction_map.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace brume {
namespace {

// To 60 degrees to each side a perspective map wastes less than an octahedral one.
constexpr double widest_angle = std::numbers::pi / 3.0;

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

// Widens an interval of angles by a disc seen from the origin of a plane, `across` to the side and
// `along` ahead. False if the origin lies in it.
bool widen(Interval& interval, double across, double along, double radius) {
  const double distance = std::hypot(across, along);
  if (!(distance > radius)) return false;
  const double center = std::atan2(across, along);
  const double half = std::asin(radius / distance);
  interval.low = std::min(interval.low, center - half);
  interval.high = std::max(interval.high, center + half);
  return interval.low > -widest_angle && interval.high < widest_angle;
}

}  // namespace

DirectionMap DirectionMap::full_sphere(int size) {
  DirectionMap map;
  map.columns = size;
  map.rows = size;
  return map;
}

DirectionMap DirectionMap::towards(const glm::dvec3& origin, std::span<const Ball> balls,
                                   int size) {
  DirectionMap map = full_sphere(size);
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  for (const Ball& ball : balls) {
    if (!(ball.radius > 0.0)) continue;
    low = glm::min(low, ball.center - ball.radius);
    high = glm::max(high, ball.center + ball.radius);
  }
  const glm::dvec3 center = 0.5 * (low + high) - origin;
  const double distance = glm::length(center);
  if (!(distance > 0.0) || !std::isfinite(distance)) return map;
  const glm::dvec3 axis = center / distance;
  const glm::dvec3 other = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(axis, other));
  const glm::dvec3 up = glm::cross(right, axis);
  Interval u;
  Interval v;
  for (const Ball& ball : balls) {
    if (!(ball.radius > 0.0)) continue;
    const glm::dvec3 q = ball.center - origin;
    const double along = glm::dot(q, axis);
    if (!widen(u, glm::dot(q, right), along, ball.radius) ||
        !widen(v, glm::dot(q, up), along, ball.radius)) {
      return map;
    }
  }
  map.octahedral = false;
  map.axis = glm::vec3(axis);
  map.right = glm::vec3(right);
  map.up = glm::vec3(up);
  const glm::dvec2 first(std::tan(u.low), std::tan(v.low));
  const glm::dvec2 last(std::tan(u.high), std::tan(v.high));
  map.scale = glm::vec2(2.0 / (last - first));
  map.offset = glm::vec2(-(first + last) / (last - first));
  return map.resized(size);
}

DirectionMap DirectionMap::resized(int size) const {
  DirectionMap map = full_sphere(size);
  if (octahedral) return map;
  map = *this;
  // Square cells, as far as neither side falls below a quarter.
  const double aspect =
      std::clamp(static_cast<double>(scale.y) / static_cast<double>(scale.x), 1.0 / 16.0, 16.0);
  map.columns = static_cast<int>(std::lround(size * std::sqrt(aspect)));
  map.rows = static_cast<int>(std::lround(size / std::sqrt(aspect)));
  return map;
}

glm::dvec3 DirectionMap::direction(int x, int y) const {
  double u = (2.0 * x + 1.0) / columns - 1.0;
  double v = (2.0 * y + 1.0) / rows - 1.0;
  if (!octahedral) {
    return glm::normalize(
        glm::dvec3(axis) +
        (u - static_cast<double>(offset.x)) / static_cast<double>(scale.x) * glm::dvec3(right) +
        (v - static_cast<double>(offset.y)) / static_cast<double>(scale.y) * glm::dvec3(up));
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

glm::dvec3 DirectionMap::components(const glm::dvec3& q) const {
  return {glm::dot(q, glm::dvec3(right)), glm::dot(q, glm::dvec3(up)),
          glm::dot(q, glm::dvec3(axis))};
}

double DirectionMap::cell_angle() const {
  // Cells of the octahedral map are widest in the middle of its faces' edges.
  if (octahedral) return 2.0 / columns;
  return 2.0 /
         std::min(static_cast<double>(scale.x) * columns, static_cast<double>(scale.y) * rows);
}

}  // namespace brume
