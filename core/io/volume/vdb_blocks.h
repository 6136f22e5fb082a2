#pragma once

#include <cstddef>
#include <functional>

#include "core/io/volume/vdb_file.h"
#include "core/volume/density_grid.h"

namespace brume {

// A reader positioned at a grid's tree and limited to the grid. grid.values must be set.
ByteReader vdb_tree(const std::filesystem::path& file, std::string_view bytes, const VdbGrid& grid);

// One component of the active values of a grid, mapped by to_value; tiles become voxels. Throws
// InputError: damaged, a sheared or non-linear transform, more than limits::volume_blocks, or from
// to_value.
DensityGrid read_vdb_blocks(const std::filesystem::path& file, std::string_view bytes,
                            const VdbGrid& grid, std::size_t component,
                            const std::function<float(double)>& to_value);

}  // namespace brume
