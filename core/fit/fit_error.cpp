#include "core/fit/fit_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "core/transport/optical_depth.h"

namespace brume {
namespace {

// The stretch of a line inside a box, parameters in units of w.
struct Stretch {
  double begin = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();
};

Stretch inside(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& p,
               const glm::dvec3& w) {
  Stretch stretch;
  for (int k = 0; k < 3; ++k) {
    if (w[k] == 0.0) continue;
    const double a = (low[k] - p[k]) / w[k];
    const double b = (high[k] - p[k]) / w[k];
    stretch.begin = std::max(stretch.begin, std::min(a, b));
    stretch.end = std::min(stretch.end, std::max(a, b));
  }
  return stretch;
}

}  // namespace

double depth_error(const DensityGrid& grid, std::span<const Gaussian> gaussians, std::size_t lines,
                   std::uint32_t seed) {
  if (grid.blocks.empty()) return 0.0;
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  for (const DensityGrid::Block& block : grid.blocks) {
    low = glm::min(low, glm::dvec3(block.corner));
    high = glm::max(high, glm::dvec3(block.corner + (DensityGrid::side - 1)));
  }
  std::mt19937 random(seed);
  const auto point = [&] {
    glm::dvec3 p;
    for (int k = 0; k < 3; ++k) p[k] = low[k] + (high[k] - low[k]) * (random() / 4294967296.0);
    return p;
  };
  struct Line {
    glm::dvec3 p, w;  // [voxels], |w| = 1
  };
  std::vector<Line> all(lines);
  for (Line& line : all) {
    line.p = point();
    line.w = glm::normalize(point() - line.p + 1e-9);
  }

  std::vector<double> wrong(lines);
  std::vector<double> right(lines);
  tbb::parallel_for(std::size_t{0}, lines, [&](std::size_t i) {
    const auto [p, w] = all[i];
    const Stretch stretch = inside(low - 1.0, high + 1.0, p, w);
    const auto steps = static_cast<int>(std::ceil((stretch.end - stretch.begin) / 0.5));
    const double step = (stretch.end - stretch.begin) / steps;
    double depth = 0.0;
    for (int k = 0; k < steps; ++k) depth += grid.at(p + (stretch.begin + (k + 0.5) * step) * w);
    const glm::dvec3 from = grid.to_world(p);
    const glm::dvec3 along = grid.to_world(p + w) - from;
    const double voxel = glm::length(along);
    depth *= step * voxel;

    // Gaussians reach out of the box.
    const double far = 2.0 * glm::length(high - low) * voxel;
    double fitted = 0.0;
    for (const Gaussian& g : gaussians) {
      fitted += optical_depth(g, from - far / voxel * along, from + far / voxel * along);
    }
    wrong[i] = (fitted - depth) * (fitted - depth);
    right[i] = depth * depth;
  });
  double error = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < lines; ++i) {
    error += wrong[i];
    scale += right[i];
  }
  return scale > 0.0 ? std::sqrt(error / scale) : 0.0;
}

double mass_ratio(const DensityGrid& grid, std::span<const Gaussian> gaussians) {
  double integral = 0.0;
  for (const Gaussian& g : gaussians) {
    integral += g.density * std::pow(std::sqrt(std::numbers::pi) * g.mean_radius(), 3.0);
  }
  return integral / grid.integral();
}

}  // namespace brume
