#include "render/grid/axis_planes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <ranges>

namespace brume {
namespace {

// The least cosine between a normal and an axis: a tilt of less does not leave the margins over the
// links of one node.
constexpr double min_cosine = 0.99999;

}  // namespace

AxisPlanes::AxisPlanes(const RayCaster& ray_caster) {
  ray_caster.for_each_triangle([&](const WorldTriangle& triangle) {
    const auto& [a, b, c] = triangle.positions;
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    const double length = glm::length(normal);
    for (int k = 0; k < 3; ++k) {
      if (!(std::abs(normal[k]) > min_cosine * length)) continue;
      planes_[static_cast<std::size_t>(k)].push_back(
          {ray_caster.center()[k] + static_cast<double>(a[k]), 0.5 * length});
    }
  });
  for (std::vector<Plane>& planes : planes_) {
    std::ranges::sort(planes, {}, &Plane::coordinate);
    // Triangles of one plane are one, and those of a slightly uneven one.
    const double tolerance = 1e-5 * ray_caster.radius();
    std::vector<Plane> merged;
    for (const Plane& plane : planes) {
      if (!merged.empty() && plane.coordinate - merged.back().coordinate <= tolerance) {
        merged.back().area += plane.area;
      } else {
        merged.push_back(plane);
      }
    }
    planes = std::move(merged);
  }
}

double AxisPlanes::shift(int axis, double low, double high, double first, double spacing) const {
  const std::vector<Plane>& all = planes_[static_cast<std::size_t>(axis)];
  const std::ranges::subrange planes(std::ranges::lower_bound(all, low, {}, &Plane::coordinate),
                                     std::ranges::upper_bound(all, high, {}, &Plane::coordinate));
  constexpr double too_near = 0.02;    // [spacing]
  constexpr double negligible = 0.01;  // share of the area
  constexpr int candidates = 16;
  constexpr double clear = 0.1;  // [spacing], at which a plane is half as well placed as halfway
  double area = 0.0;
  double area_on_layers = 0.0;
  for (const Plane& plane : planes) {
    const double layer = (plane.coordinate - first) / spacing;
    area += plane.area;
    if (std::abs(layer - std::round(layer)) < too_near) area_on_layers += plane.area;
  }
  if (!(area_on_layers > negligible * area)) return 0.0;
  double best = 0.0;
  double most = -1.0;
  for (int i = 0; i < candidates; ++i) {
    const double shift = static_cast<double>(i) / candidates - 0.5;
    double sum = 0.0;
    for (const Plane& plane : planes) {
      const double layer = (plane.coordinate - first) / spacing - shift;
      const double distance = std::abs(layer - std::round(layer));
      sum += plane.area * distance / (distance + clear);
    }
    if (sum <= most * (1.0 + 1e-9)) continue;
    most = sum;
    best = shift;
  }
  return best * spacing;
}

}  // namespace brume
