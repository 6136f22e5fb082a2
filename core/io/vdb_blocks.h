#pragma once

#include <cstddef>
#include <functional>

#include "core/io/vdb_file.h"
#include "core/volume/density_grid.h"

namespace brume {

// Stands at a grid's tree and ends where the grid does. grid.values must be there.
ByteReader vdb_tree(const std::filesystem::path& file, std::string_view bytes, const VdbGrid& grid);

// Component `component` of the active values of a grid, each as to_value(it); tiles become voxels.
// Throws InputError: damaged, a transform that shears or is not linear, more than
// limits::volume_blocks, or what to_value throws.
DensityGrid read_vdb_blocks(const std::filesystem::path& file, std::string_view bytes,
                            const VdbGrid& grid, std::size_t component,
                            const std::function<float(double)>& to_value);

}  // namespace brume
