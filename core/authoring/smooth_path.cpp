#include "core/authoring/smooth_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace brume {
namespace {

constexpr double min_step = 1e-6;  // pixels; nearer ones are the same position

}  // namespace

// By the pyramid of Barry and Goldman: each point of a level is linear in the parameter between two
// of the level below.
std::vector<glm::dvec2> catmull_rom(const std::array<glm::dvec2, 4>& points, double spacing) {
  assert(spacing > 0.0);
  std::array<double, 4> knots{};
  for (std::size_t k = 1; k < 4; ++k) {
    assert(points[k] != points[k - 1]);
    knots[k] = knots[k - 1] + std::sqrt(glm::distance(points[k - 1], points[k]));
  }
  const int count =
      std::max(1, static_cast<int>(std::ceil(glm::distance(points[1], points[2]) / spacing)));
  std::vector<glm::dvec2> curve;
  curve.reserve(static_cast<std::size_t>(count));
  for (int i = 1; i < count; ++i) {
    const double t = knots[1] + (knots[2] - knots[1]) * i / count;
    std::array<glm::dvec2, 4> level = points;
    for (std::size_t width = 1; width < 3; ++width) {
      for (std::size_t k = 0; k + width < 4; ++k) {
        const double fraction = (t - knots[k]) / (knots[k + width] - knots[k]);
        level[k] += fraction * (level[k + 1] - level[k]);
      }
    }
    const double fraction = (t - knots[1]) / (knots[2] - knots[1]);
    curve.push_back(level[0] + fraction * (level[1] - level[0]));
  }
  curve.push_back(points[2]);
  return curve;
}

SmoothPath::SmoothPath(const glm::dvec2& start, double spacing) : spacing_(spacing), last_{start} {}

std::vector<glm::dvec2> SmoothPath::extend(const glm::dvec2& position) {
  if (glm::distance(position, last_.back()) < min_step) return {};
  // At its ends the curve is tangent to the line between two positions.
  if (last_.size() == 1) last_.insert(last_.begin(), 2.0 * last_.front() - position);
  last_.push_back(position);
  if (last_.size() < 4) return {};
  const std::array points{last_[0], last_[1], last_[2], last_[3]};
  last_.erase(last_.begin());
  return catmull_rom(points, spacing_);
}

std::vector<glm::dvec2> SmoothPath::end() {
  if (last_.size() < 3) return {};
  const std::array points{last_[0], last_[1], last_[2], 2.0 * last_[2] - last_[1]};
  last_ = {points[2]};
  return catmull_rom(points, spacing_);
}

}  // namespace brume
