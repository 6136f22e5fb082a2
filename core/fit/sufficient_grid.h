#pragma once

#include <cstddef>
#include <optional>

#include "brume/density_grid.h"

namespace brume {

// More voxels than these tell a fit of `count` Gaussians nothing more.
constexpr std::size_t sufficient_voxels(std::size_t count) {
  return 1024 * count;
}

// The grid at a resolution that suffices for `count` Gaussians: the time of a fit follows the
// voxels, and where each Gaussian has thousands of them, fewer tell as much. nullopt: the grid
// itself.
std::optional<DensityGrid> sufficient_grid(const DensityGrid& grid, std::size_t count);

}  // namespace brume
