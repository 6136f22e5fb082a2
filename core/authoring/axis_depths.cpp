#include "core/authoring/axis_depths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <limits>
#include <numbers>

#include "core/transport/optical_depth.h"

namespace brume {
namespace {

constexpr int cells_across = 128;

std::size_t index(int column, int row) {
  return static_cast<std::size_t>(row) * cells_across + static_cast<std::size_t>(column);
}

}  // namespace

AxisDepths::AxisDepths(const Medium& medium) {
  low_ = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < medium.size(); ++i) {
    low_ = glm::min(low_, medium.centers()[i] - medium.radii()[i]);
    high = glm::max(high, medium.centers()[i] + medium.radii()[i]);
  }
  size_ = glm::max(high - low_, 1e-300) / double{cells_across};
  for (auto& image : depths_) image.assign(std::size_t{cells_across} * cells_across, 0.0);
  for (std::size_t i = 0; i < medium.size(); ++i) add(medium.gaussian(i));
}

double AxisDepths::least(const glm::dvec3& x) const {
  const glm::ivec3 cell = cell_of(x);
  double depth = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    depth = std::min(
        depth,
        depths_[static_cast<std::size_t>(axis)][index(cell[(axis + 1) % 3], cell[(axis + 2) % 3])]);
  }
  return depth;
}

glm::ivec3 AxisDepths::cell_of(const glm::dvec3& x) const {
  return glm::ivec3(glm::clamp((x - low_) / size_, 0.0, cells_across - 1.0));
}

// Spread evenly over the square of its size that has its greatest depth's share.
void AxisDepths::add(const Gaussian& gaussian, double times) {
  const double mass =
      times * gaussian.density * std::pow(std::sqrt(std::numbers::pi) * gaussian.mean_radius(), 3);
  glm::dvec3 reach(1.0);
  if (!gaussian.is_ball()) reach = Ellipsoid<double>(gaussian.shape).reach();
  const glm::dvec3 half = 0.5 * std::sqrt(std::numbers::pi) * gaussian.radius * reach;
  const glm::ivec3 first = cell_of(gaussian.center - half);
  const glm::ivec3 last = cell_of(gaussian.center + half);
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double width = (last[u] - first[u] + 1) * size_[u];
    const double height = (last[v] - first[v] + 1) * size_[v];
    std::vector<double>& image = depths_[static_cast<std::size_t>(axis)];
    for (int row = first[v]; row <= last[v]; ++row) {
      for (int column = first[u]; column <= last[u]; ++column) {
        double& depth = image[index(column, row)];
        depth = std::max(depth + mass / (width * height), 0.0);  // rounding may leave less
      }
    }
  }
}

}  // namespace brume
