#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "brume/export.h"

namespace brume {

// A sparse density grid in blocks of 8 x 8 x 8 voxels, 0 elsewhere. World position of voxel (i, j,
// k):
//   origin + rotation * (spacing * (i, j, k)).
struct BRUME_EXPORT DensityGrid {
  static constexpr int side = 8;
  static constexpr std::size_t block_size = std::size_t{side} * side * side;
  using Values = std::array<float, block_size>;

  struct Block {
    glm::ivec3 corner;  // minimum voxel, a multiple of 8
    Values values;      // >= 0 [1/u], z fastest
  };

  std::vector<Block> blocks;  // unique corners, in lexicographic order
  glm::dvec3 spacing{1.0};    // [u]; an axis may be negative, none is 0
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 origin{0.0};

  [[nodiscard]] double voxel_volume() const;  // [u^3]
  // The integral of the density [u^2].
  [[nodiscard]] double integral() const;
  [[nodiscard]] std::optional<std::size_t> find(const glm::ivec3& corner) const;
  // Density at a point in voxel coordinates, trilinear.
  [[nodiscard]] double at(const glm::dvec3& voxel) const;
  [[nodiscard]] glm::dvec3 to_world(const glm::dvec3& voxel) const;
  [[nodiscard]] glm::dvec3 to_voxel(const glm::dvec3& world) const;

  // Sorts the blocks.
  void sort();
};

// Three channels, RGB, with the same blocks.
using ColorGrid = std::array<DensityGrid, 3>;

// The colours of a density grid's matter, on the same voxels.
struct VolumeColors {
  std::optional<ColorGrid> albedo;    // in (0, 1], 0 where there is no matter
  std::optional<ColorGrid> emission;  // [W/(sr u^2)] per unit of extinction optical depth
};

// The grid of a dense array of size.x * size.y * size.z densities >= 0 [1/u], z fastest: voxel (i,
// j, k) lies at origin + spacing * (i, j, k) [u]. Throws DomainError.
BRUME_EXPORT DensityGrid grid_of(std::span<const float> values, const glm::ivec3& size,
                                 double spacing, const glm::dvec3& origin = glm::dvec3(0.0));

// Downsamples by two: each voxel is the mean of eight, preserving mass.
BRUME_EXPORT DensityGrid coarser(const DensityGrid& grid);
// The grid, downsampled until it has at most `max_blocks`.
BRUME_EXPORT DensityGrid at_most(DensityGrid grid, std::size_t max_blocks);

// Rotates a grid about the world origin.
BRUME_EXPORT void rotate(DensityGrid& grid, const glm::dquat& turn);

// The corner of the block that contains a voxel.
BRUME_EXPORT glm::ivec3 block_corner(const glm::ivec3& voxel);

}  // namespace brume
