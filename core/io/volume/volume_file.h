#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "brume/density_grid.h"
#include "brume/limits.h"
#include "core/volume/velocity_grid.h"

namespace brume {

// OpenVDB files (.vdb).

// Reads a scalar grid of any number type as density, with its transform (rotation, reflection and
// axis scaling); booleans are 0 and 1. Of several grids of the name it is the sum. Negative values,
// as solvers leave them, become 0. Voxels must be finite, at most limits::density, and at most
// limits::voxels active. Throws InputError naming the file, and its grids if there is none of that
// name.
DensityGrid read_volume(const std::filesystem::path& file, const std::string& grid);

// A warning on a file that is read: that its version of the format is newer than those
// known. Throws InputError.
std::vector<std::string> volume_warnings(const std::filesystem::path& file);

// Reads a three-component grid `velocity`, `vel` or `v`, if present: in world axes [u/s], sampled
// at voxels or, if staggered, on their faces. Throws InputError.
std::optional<VelocityGrid> read_velocity(const std::filesystem::path& file);

struct VolumeGridInfo {
  std::string name;
  std::string type;          // OpenVDB's type name
  std::uint64_t voxels = 0;  // active ones
  std::uint64_t blocks = 0;  // of 8 x 8 x 8 voxels, that have active ones
  glm::dvec3 voxel_size{0.0};
  // World bounds of the active voxels.
  glm::dvec3 min_corner{0.0};
  glm::dvec3 max_corner{0.0};
};
// Lists the grids of a file. Throws InputError.
std::vector<VolumeGridInfo> volume_grids(const std::filesystem::path& file);

// The finite values of a grid's active voxels, of several components their lengths.
struct ValueRange {
  double min_value = 0.0;
  double max_value = 0.0;
};
// The ranges of all grids of a file, in the order of volume_grids(); nullopt without values, or if
// they cannot be read. Nothing if stopped. Throws InputError.
std::vector<std::optional<ValueRange>> value_ranges(const std::filesystem::path& file,
                                                    const std::stop_token& stop = {});

// Writes fog volumes, sparse: the grid `density`, and the grids `albedo` and `emission` of three
// components where there are any; densities and albedos in half precision (11 bits) if asked for.
// Throws InputError if the file cannot be written.
void write_volume(const std::filesystem::path& file, const DensityGrid& density, bool half,
                  const VolumeColors& colors = {});

}  // namespace brume
