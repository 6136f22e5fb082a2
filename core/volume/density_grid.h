#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace brume {

// A density sampled at the points of a regular grid, stored in cubes of 8 x 8 x 8 voxels; it is 0
// where there is no cube. The point of voxel (i, j, k) in the world is
//   origin + rotation * (spacing * (i, j, k)).
struct DensityGrid {
  static constexpr int side = 8;
  static constexpr std::size_t block_size = side * side * side;
  using Values = std::array<float, block_size>;

  struct Block {
    glm::ivec3 corner;  // its least voxel, a multiple of 8
    Values values;      // >= 0 [1/u], z fastest
  };

  std::vector<Block> blocks;  // each corner once, in ascending order: x, then y, then z
  glm::dvec3 spacing{1.0};    // [u]; an axis may be negative, none is 0
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 origin{0.0};

  [[nodiscard]] double voxel_volume() const;  // [u^3]
  // The integral of the density [u^2].
  [[nodiscard]] double mass() const;
  [[nodiscard]] std::optional<std::size_t> find(const glm::ivec3& corner) const;
  // The density at a point of the grid's own coordinates, voxels; linear between voxels.
  [[nodiscard]] double at(const glm::dvec3& voxel) const;
  [[nodiscard]] glm::dvec3 to_world(const glm::dvec3& voxel) const;
  [[nodiscard]] glm::dvec3 to_voxel(const glm::dvec3& world) const;

  // Sorts the blocks, as they must be.
  void sort();
};

// The grid with voxels of twice the spacing, each the mean of eight: same mass.
DensityGrid coarser(const DensityGrid& grid);

// The least corner of a block that holds a voxel.
glm::ivec3 block_corner(const glm::ivec3& voxel);

}  // namespace brume
