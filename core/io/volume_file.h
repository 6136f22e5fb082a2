#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/volume/density_grid.h"
#include "core/volume/velocity_grid.h"

namespace brume {

// OpenVDB files (.vdb).

// Reads a scalar grid of any type of number as a density: its transform becomes the grid's (it may
// turn, mirror and stretch along its axes); negative values, as solvers leave them, become 0.
// Voxels must be finite and at most limits::density, and at most limits::voxels active ones. Throws
// InputError naming the file, and what grids it has where there is none of that name.
DensityGrid read_volume(const std::filesystem::path& file, const std::string& grid);

// Reads the grid `velocity`, `vel` or `v` if the file has one of three numbers each: in the world's
// axes [u/s], at the voxels' points or, of a staggered grid, on their faces. Throws InputError.
std::optional<VelocityGrid> read_velocity(const std::filesystem::path& file);

struct VolumeGridInfo {
  std::string name;
  std::string type;          // as OpenVDB calls it
  std::uint64_t voxels = 0;  // active ones
  glm::dvec3 voxel_size{0.0};
  // The box in the world around the active voxels' points.
  glm::dvec3 least{0.0};
  glm::dvec3 greatest{0.0};
};
// What grids a file has. Throws InputError.
std::vector<VolumeGridInfo> volume_grids(const std::filesystem::path& file);

// Writes a fog volume of the grid `density`, sparse, in half precision (11 bits) if asked for.
// Throws InputError if the file cannot be written.
void write_volume(const std::filesystem::path& file, const DensityGrid& grid, bool half);

}  // namespace brume
