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
#include "core/volume/block_tree.h"

namespace brume {
namespace {

// Where lines begin and end: in the box around the blocks or, where they fill less than a
// thousandth of it, in blocks, since hardly a line through the box would meet one.
class LinePoints {
 public:
  LinePoints(const DensityGrid& grid, std::uint32_t seed) : grid_(grid), random_(seed) {
    for (const DensityGrid::Block& block : grid.blocks) {
      low_ = glm::min(low_, glm::dvec3(block.corner));
      high_ = glm::max(high_, glm::dvec3(block.corner + (DensityGrid::side - 1)));
    }
    const glm::dvec3 size = high_ - low_ + 1.0;
    const double filled = static_cast<double>(grid.blocks.size() * DensityGrid::block_size) /
                          (size.x * size.y * size.z);
    is_sparse_ = filled < 1e-3;
  }

  // [voxels]
  glm::dvec3 next() {
    glm::dvec3 low = low_;
    glm::dvec3 size = high_ - low_;
    if (is_sparse_) {
      const auto block =
          static_cast<std::size_t>(uniform() * static_cast<double>(grid_.blocks.size()));
      low = grid_.blocks[block].corner;
      size = glm::dvec3(DensityGrid::side - 1);
    }
    glm::dvec3 p;
    for (int k = 0; k < 3; ++k) p[k] = low[k] + size[k] * uniform();
    return p;
  }

  [[nodiscard]] double diagonal() const { return glm::length(high_ - low_); }  // [voxels]

 private:
  double uniform() { return static_cast<double>(random_()) / 4294967296.0; }

  const DensityGrid& grid_;
  std::mt19937 random_;
  glm::dvec3 low_{std::numeric_limits<double>::infinity()};
  glm::dvec3 high_{-std::numeric_limits<double>::infinity()};
  bool is_sparse_;
};

// The optical depth of the line p + t w, |w| = 1 [voxels].
double depth_along_line(const DensityGrid& grid, const BlockTree& tree, const glm::dvec3& p,
                        const glm::dvec3& w) {
  double depth = 0.0;
  for (const auto& [begin, end] : tree.intervals(p, w)) {
    const auto steps = static_cast<int>(std::ceil((end - begin) / 0.5));
    const double step = (end - begin) / std::max(steps, 1);
    for (int k = 0; k < steps; ++k) depth += step * grid.at(p + (begin + (k + 0.5) * step) * w);
  }
  return depth;
}

}  // namespace

double depth_error(const DensityGrid& grid, std::span<const Gaussian> gaussians, std::size_t lines,
                   std::uint32_t seed) {
  if (grid.blocks.empty()) return 0.0;
  LinePoints points(grid, seed);
  const BlockTree tree(grid.blocks);
  struct Line {
    glm::dvec3 p, w;  // [voxels], |w| = 1
  };
  std::vector<Line> all(lines);
  for (Line& line : all) {
    line.p = points.next();
    line.w = glm::normalize(points.next() - line.p + 1e-9);
  }

  std::vector<double> wrong(lines);
  std::vector<double> right(lines);
  tbb::parallel_for(std::size_t{0}, lines, [&](std::size_t i) {
    const auto [p, w] = all[i];
    const glm::dvec3 origin = grid.to_world(p);
    const glm::dvec3 along = grid.to_world(p + w) - origin;
    const double voxel = glm::length(along);
    const double depth = depth_along_line(grid, tree, p, w) * voxel;

    // Gaussians reach out of the box.
    const double far = 2.0 * points.diagonal() * voxel;
    double fitted = 0.0;
    for (const Gaussian& g : gaussians) {
      fitted += optical_depth(g, origin - far / voxel * along, origin + far / voxel * along);
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
