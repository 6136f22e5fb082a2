#include "core/scene/lights/filled_rectangle.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

#include "core/math/basis.h"

namespace brume {
namespace {

// A rectangle around triangles, with a side along `right`.
struct Frame {
  glm::dvec3 right, up, normal;
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};

  Frame(std::span<const std::array<glm::dvec3, 3>> triangles, const glm::dvec3& side,
        const glm::dvec3& unit_normal)
      : right(side), up(glm::cross(side, unit_normal)), normal(unit_normal) {
    for (const auto& triangle : triangles) {
      for (const glm::dvec3& corner : triangle) {
        const glm::dvec2 place(glm::dot(corner, right), glm::dot(corner, up));
        low = glm::min(low, place);
        high = glm::max(high, place);
      }
    }
  }
  [[nodiscard]] double area() const { return (high.x - low.x) * (high.y - low.y); }
};

// So many triangles, spread over all of them, say along which sides a rectangle may lie.
constexpr std::size_t max_tried = 16;
constexpr double min_fill = 0.5;
constexpr double max_fill = 1.5;

}  // namespace

std::optional<FilledRectangle> filled_rectangle(
    std::span<const std::array<glm::dvec3, 3>> triangles, double area, const glm::dvec3& normal) {
  if (triangles.empty()) return std::nullopt;
  Frame smallest(triangles, make_basis(normal).u, normal);
  const std::size_t step = (triangles.size() + max_tried - 1) / max_tried;
  for (std::size_t t = 0; t < triangles.size(); t += step) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 edge = triangles[t][(k + 1) % 3] - triangles[t][k];
      const glm::dvec3 side = edge - glm::dot(edge, normal) * normal;
      if (!(glm::length(side) > 0.0)) continue;
      const Frame frame(triangles, glm::normalize(side), normal);
      if (frame.area() < smallest.area()) smallest = frame;
    }
  }
  if (!(area > min_fill * smallest.area() && area < max_fill * smallest.area())) {
    return std::nullopt;
  }
  glm::dvec3 center(0.0);
  for (const auto& [a, b, c] : triangles) {
    const double share = 0.5 * glm::length(glm::cross(b - a, c - a)) / area;
    center += share / 3.0 * (a + b + c);
  }
  const double scale = std::sqrt(area / smallest.area());
  const glm::dvec2 size = scale * (smallest.high - smallest.low);
  return FilledRectangle{center, smallest.up, size.x, size.y};
}

}  // namespace brume
