#include "core/fit/sufficient_grid.h"

#include <utility>

namespace brume {

std::optional<DensityGrid> sufficient_grid(const DensityGrid& grid, std::size_t count) {
  std::optional<DensityGrid> result;
  for (const DensityGrid* last = &grid;
       last->blocks.size() * DensityGrid::block_size > sufficient_voxels(count); last = &*result) {
    DensityGrid half = coarser(*last);
    if (2 * half.blocks.size() > last->blocks.size()) break;  // of scattered blocks it has as many
    result = std::move(half);
  }
  return result;
}

}  // namespace brume
