#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "render/geometry/box.h"

namespace brume {

// The origin of float coordinates of surfaces: the middle of all, unless some surfaces are
// so small beside their distance from it that rounding would deform them, as a box where one more
// object is far away. Then it is the middle of that surface around which fewest are deformed.
inline glm::dvec3 coordinate_center(const Box& all, std::span<const Box> surfaces) {
  constexpr double max_distance = 1024.0;  // in sizes of a surface; rounding is 1e-4 of it there
  constexpr std::size_t max_candidates = 256;
  const auto middle = [](const Box& box) { return 0.5 * (box.low + box.high); };
  // Larger surfaces count more, but not in proportion: a planet is less than all that is near.
  const auto deformation = [&](const glm::dvec3& center) {
    double sum = 0.0;
    for (const Box& box : surfaces) {
      const double size = glm::length(box.high - box.low);
      const double distance = glm::length(middle(box) - center);
      if (!(distance > 0.0)) continue;
      const double share = std::min(distance / (max_distance * size), 1.0);
      sum += std::sqrt(size) * share * share;
    }
    return sum;
  };
  const auto deforms = [&](const Box& box) {
    return glm::length(middle(box) - middle(all)) > max_distance * glm::length(box.high - box.low);
  };
  glm::dvec3 center = middle(all);
  if (std::ranges::none_of(surfaces, deforms)) return center;
  double least = std::numeric_limits<double>::infinity();
  const std::size_t step = (surfaces.size() + max_candidates - 1) / max_candidates;
  for (std::size_t i = 0; i < surfaces.size(); i += step) {
    const double sum = deformation(middle(surfaces[i]));
    if (!(sum < least)) continue;
    least = sum;
    center = middle(surfaces[i]);
  }
  return center;
}

}  // namespace brume
