#include "core/authoring/spline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace brume {
namespace {

constexpr int max_segment_samples = 4096;

// A point of the segment from the second to the third, by the pyramid of Barry and Goldman.
glm::dvec3 spline_point(std::array<glm::dvec3, 4> level, const std::array<double, 4>& knots,
                        double t) {
  for (std::size_t width = 1; width < 3; ++width) {
    for (std::size_t k = 0; k + width < 4; ++k) {
      const double fraction = (t - knots[k]) / (knots[k + width] - knots[k]);
      level[k] += fraction * (level[k + 1] - level[k]);
    }
  }
  return level[0] + (t - knots[1]) / (knots[2] - knots[1]) * (level[1] - level[0]);
}

}  // namespace

std::vector<glm::dvec3> sample_spline(std::span<const glm::dvec3> points, double spacing) {
  assert(spacing > 0.0);
  std::vector<glm::dvec3> distinct;
  for (const glm::dvec3& point : points) {
    if (distinct.empty() || distinct.back() != point) distinct.push_back(point);
  }
  if (distinct.size() < 2) return distinct;
  const std::size_t last = distinct.size() - 1;
  distinct.insert(distinct.begin(), 2.0 * distinct[0] - distinct[1]);
  distinct.push_back(2.0 * distinct[last + 1] - distinct[last]);
  std::vector<glm::dvec3> samples{distinct[1]};
  for (std::size_t i = 0; i < last; ++i) {
    const std::array segment{distinct[i], distinct[i + 1], distinct[i + 2], distinct[i + 3]};
    std::array<double, 4> knots{};
    for (std::size_t k = 1; k < 4; ++k) {
      knots[k] = knots[k - 1] + std::sqrt(glm::distance(segment[k - 1], segment[k]));
    }
    const double steps = std::ceil(glm::distance(segment[1], segment[2]) / spacing);
    const int count = static_cast<int>(std::clamp<double>(steps, 1.0, max_segment_samples));
    for (int j = 1; j < count; ++j) {
      const double t = knots[1] + (knots[2] - knots[1]) * j / count;
      samples.push_back(spline_point(segment, knots, t));
    }
    samples.push_back(segment[2]);
  }
  return samples;
}

}  // namespace brume
