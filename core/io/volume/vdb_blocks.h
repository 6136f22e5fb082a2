#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "brume/density_grid.h"
#include "brume/limits.h"
#include "core/io/volume/vdb_file.h"

namespace brume {

// A reader positioned at a grid's tree and limited to the grid. grid.values must be set.
ByteReader vdb_tree(const std::filesystem::path& file, std::string_view bytes, const VdbGrid& grid);

// One component of the active values of grids of one name, mapped by to_value and summed; tiles
// become voxels. Throws InputError: damaged, a sheared or non-linear transform, grids whose voxels
// do not coincide, more than limits::volume_blocks, or from to_value.
DensityGrid read_vdb_blocks(const std::filesystem::path& file, std::string_view bytes,
                            std::span<const VdbGrid> grids, std::size_t component,
                            const std::function<float(double)>& to_value);

// The same of a density: fog volumes of one number per voxel, negative ones, as solvers leave
// them, become 0. Throws InputError for other grids, and for numbers that are not finite or more
// than limits::density.
DensityGrid read_vdb_density(const std::filesystem::path& file, std::string_view bytes,
                             std::span<const VdbGrid> grids);

// Refuses grids other than fog volumes of `components` numbers per voxel, 1 or 3. Throws
// InputError.
void require_fog(const std::filesystem::path& file, std::span<const VdbGrid> grids,
                 std::size_t components);

}  // namespace brume
