#include "core/fit/volume_survey.h"

#include <algorithm>
#include <cmath>

#include "core/fit/sufficient_grid.h"
#include "core/fit/volume_fitter.h"

namespace brume {

bool is_probably_z_up(const VolumeGridInfo& grid) {
  constexpr double doubt = 0.1;
  const glm::dvec3 extent = grid.max_corner - grid.min_corner + grid.voxel_size;
  const double y = std::abs(std::log(extent.y / extent.x));
  const double z = std::abs(std::log(extent.z / extent.x));
  return z > y + doubt;  // false where extents are no numbers
}

FitCost estimate_fit_cost(std::uint64_t blocks, const FitOptions& options, unsigned threads) {
  // Measured on one core, of 500 Gaussians.
  constexpr double seconds_per_voxel = 3.2e-4;
  constexpr double ball_share = 0.42;
  constexpr double final_share = 0.05;  // of the steps, at the full resolution
  constexpr double bytes_per_block = 6e3;
  auto fitted = static_cast<double>(blocks);
  while (fitted > max_fitted_blocks) fitted /= 8.0;
  const auto count = static_cast<double>(options.count);
  const double voxels = DensityGrid::block_size * fitted;
  double coarse = voxels;
  while (coarse > max_voxels_per_gaussian * count) coarse /= 8.0;
  const double steps = coarse + (coarse < voxels ? final_share * voxels : 0.0);
  double seconds = seconds_per_voxel * std::sqrt(count / 500.0) * steps / std::max(1u, threads);
  if (options.shape == FitShape::ball) seconds *= ball_share;
  return {seconds, bytes_per_block * fitted + sizeof(DensityGrid::Block) * blocks};
}

}  // namespace brume
