#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/medium/gaussian.h"
#include "core/volume/density_grid.h"

namespace brume {

// How far the optical depth of Gaussians is from that of a grid, relative RMS over lines through
// two random points each of the box around the grid's blocks; the grid's density is linear between
// voxels, summed every half voxel (good to 1%). 0 for an empty grid. In parallel.
double depth_error(const DensityGrid& grid, std::span<const Gaussian> gaussians,
                   std::size_t lines = 10'000, std::uint32_t seed = 1);

// The mass of Gaussians over that of the grid.
double mass_ratio(const DensityGrid& grid, std::span<const Gaussian> gaussians);

}  // namespace brume
