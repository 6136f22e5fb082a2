#include "core/fit/volume_survey.h"

#include <algorithm>
#include <cmath>

#include "core/fit/sufficient_grid.h"
#include "core/fit/volume_fitter.h"

namespace brume {

namespace {

// Grids of `count` blocks or voxels have so many when they are made coarser until there are at
// most `max_count`.
double coarsened(double count, double max_count) {
  while (count > max_count) count /= 8.0;
  return count;
}

}  // namespace

bool is_probably_z_up(const VolumeGridInfo& grid) {
  constexpr double alike = 1.35;  // ratios of extents
  constexpr double different = 1.5;
  const glm::dvec3 extent = grid.max_corner - grid.min_corner + grid.voxel_size;
  const double y = std::abs(std::log(extent.y / extent.x));
  const double z = std::abs(std::log(extent.z / std::sqrt(extent.x * extent.y)));
  return y < std::log(alike) && z > std::log(different);  // false where extents are no numbers
}

FitCost estimate_fit_cost(std::uint64_t blocks, const FitOptions& options, unsigned threads) {
  // Measured on one core, of 500 Gaussians.
  constexpr double seconds_per_voxel = 3.2e-4;
  constexpr double ball_share = 0.42;
  constexpr double final_share = 0.05;  // of the steps, at the full resolution
  const double fitted = coarsened(static_cast<double>(blocks), max_fitted_blocks);
  const double voxels = DensityGrid::block_size * fitted;
  const auto sufficient = static_cast<double>(sufficient_voxels(options.count));
  const double coarse = coarsened(voxels, sufficient);
  const double steps = coarse + (coarse < voxels ? final_share * voxels : 0.0);
  const double size = std::sqrt(static_cast<double>(options.count) / 500.0);
  double seconds = seconds_per_voxel * size * steps / std::max(1u, threads);
  if (options.shape == FitShape::ball) seconds *= ball_share;
  return {seconds, fit_bytes_per_block * fitted + sizeof(DensityGrid::Block) * blocks};
}

}  // namespace brume
