#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "brume/density_grid.h"
#include "brume/gaussian.h"

namespace brume {

// Relative RMS error of the Gaussians' optical depth against a grid's, over lines through two
// random points each of the bounding box of the grid's blocks, or of the blocks where these are
// nearly nothing of it. The grid is trilinear, integrated in half-voxel steps within blocks
// (accurate to 1%), in a time that follows the blocks on a line, not its length. 0 for an empty
// grid. In parallel.
double depth_error(const DensityGrid& grid, std::span<const Gaussian> gaussians,
                   std::size_t lines = 10'000, std::uint32_t seed = 1);

// Mass of the Gaussians divided by that of the grid.
double mass_ratio(const DensityGrid& grid, std::span<const Gaussian> gaussians);

}  // namespace brume
