#include "brume/density_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <string>
#include <tuple>

#include "brume/error.h"
#include "core/number_domain.h"

namespace brume {
namespace {

auto order(const glm::ivec3& corner) {
  return std::tuple(corner.x, corner.y, corner.z);
}

std::size_t index_in_block(const glm::ivec3& voxel, const glm::ivec3& corner) {
  const glm::ivec3 p = voxel - corner;
  return static_cast<std::size_t>((p.x * DensityGrid::side + p.y) * DensityGrid::side + p.z);
}

}  // namespace

glm::ivec3 block_corner(const glm::ivec3& voxel) {
  constexpr int low_bits = DensityGrid::side - 1;
  return {voxel.x & ~low_bits, voxel.y & ~low_bits, voxel.z & ~low_bits};
}

double DensityGrid::voxel_volume() const {
  return std::abs(spacing.x * spacing.y * spacing.z);
}

double DensityGrid::integral() const {
  double sum = 0.0;
  for (const Block& block : blocks) {
    for (const float value : block.values) sum += static_cast<double>(value);
  }
  return sum * voxel_volume();
}

std::optional<std::size_t> DensityGrid::find(const glm::ivec3& corner) const {
  const auto it = std::lower_bound(
      blocks.begin(), blocks.end(), corner,
      [](const Block& block, const glm::ivec3& c) { return order(block.corner) < order(c); });
  if (it == blocks.end() || it->corner != corner) return std::nullopt;
  return static_cast<std::size_t>(it - blocks.begin());
}

double DensityGrid::at(const glm::dvec3& voxel) const {
  const glm::dvec3 low = glm::floor(voxel);
  const glm::dvec3 f = voxel - low;
  double sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 corner_offset(i & 1, (i >> 1) & 1, i >> 2);
    const glm::ivec3 v = glm::ivec3(low) + corner_offset;
    const auto block = find(block_corner(v));
    if (!block) continue;
    double weight = 1.0;
    for (int k = 0; k < 3; ++k) weight *= corner_offset[k] == 1 ? f[k] : 1.0 - f[k];
    const Block& b = blocks[*block];
    sum += weight * static_cast<double>(b.values[index_in_block(v, b.corner)]);
  }
  return sum;
}

glm::dvec3 DensityGrid::to_world(const glm::dvec3& voxel) const {
  return origin + rotation * (spacing * voxel);
}

glm::dvec3 DensityGrid::to_voxel(const glm::dvec3& world) const {
  return (glm::conjugate(rotation) * (world - origin)) / spacing;
}

void DensityGrid::sort() {
  std::sort(blocks.begin(), blocks.end(),
            [](const Block& a, const Block& b) { return order(a.corner) < order(b.corner); });
}

DensityGrid coarser(const DensityGrid& grid) {
  DensityGrid result;
  result.spacing = 2.0 * grid.spacing;
  result.rotation = grid.rotation;
  // The middle of the first eight voxels.
  result.origin = grid.to_world(glm::dvec3(0.5));
  std::map<std::tuple<int, int, int>, std::size_t> places;
  for (const DensityGrid::Block& fine : grid.blocks) {
    const glm::ivec3 first = fine.corner / 2;  // corners are multiples of 8
    const glm::ivec3 corner = block_corner(first);
    const auto [place, is_new] = places.try_emplace(order(corner), result.blocks.size());
    if (is_new) result.blocks.push_back({corner, {}});
    DensityGrid::Values& values = result.blocks[place->second].values;
    std::size_t i = 0;
    for (int x = 0; x < DensityGrid::side; ++x) {
      for (int y = 0; y < DensityGrid::side; ++y) {
        for (int z = 0; z < DensityGrid::side; ++z) {
          const glm::ivec3 voxel = first + glm::ivec3(x, y, z) / 2;
          values[index_in_block(voxel, corner)] += 0.125f * fine.values[i++];
        }
      }
    }
  }
  result.sort();
  return result;
}

DensityGrid at_most(DensityGrid grid, std::size_t max_blocks) {
  while (grid.blocks.size() > max_blocks) grid = coarser(grid);
  return grid;
}

void rotate(DensityGrid& grid, const glm::dquat& turn) {
  grid.rotation = turn * grid.rotation;
  grid.origin = turn * grid.origin;
}

DensityGrid grid_of(std::span<const float> values, const glm::ivec3& size, double spacing,
                    const glm::dvec3& origin) {
  constexpr int longest = 1 << 20;  // no product of three overflows
  const bool has_sides = std::ranges::all_of(std::array{size.x, size.y, size.z},
                                             [](int side) { return side >= 1 && side <= longest; });
  if (!has_sides || values.size() != static_cast<std::size_t>(size.x) *
                                         static_cast<std::size_t>(size.y) *
                                         static_cast<std::size_t>(size.z)) {
    throw DomainError("values", "found " + std::to_string(values.size()) +
                                    "; allowed: as many as the grid has voxels, at least 1");
  }
  const auto check_number = [](const char* name, double value, const NumberDomain& domain) {
    if (!domain.contains(value)) throw DomainError(name, domain.refusal(value));
  };
  check_number("spacing", spacing, domain::length);
  for (int k = 0; k < 3; ++k) check_number("origin", origin[k], domain::coordinate);
  DensityGrid grid;
  grid.spacing = glm::dvec3(spacing);
  grid.origin = origin;
  const auto index_at = [&](int i, int j, int k) {
    return (static_cast<std::size_t>(i) * static_cast<std::size_t>(size.y) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size.z) +
           static_cast<std::size_t>(k);
  };
  glm::ivec3 corner;
  for (corner.x = 0; corner.x < size.x; corner.x += DensityGrid::side) {
    for (corner.y = 0; corner.y < size.y; corner.y += DensityGrid::side) {
      for (corner.z = 0; corner.z < size.z; corner.z += DensityGrid::side) {
        DensityGrid::Block block{corner, {}};
        bool is_empty = true;
        const glm::ivec3 end = glm::min(corner + DensityGrid::side, size);
        for (int i = corner.x; i < end.x; ++i) {
          for (int j = corner.y; j < end.y; ++j) {
            for (int k = corner.z; k < end.z; ++k) {
              const float value = values[index_at(i, j, k)];
              if (!domain::density.contains(static_cast<double>(value))) {
                throw DomainError("values[" + std::to_string(i) + "][" + std::to_string(j) + "][" +
                                      std::to_string(k) + "]",
                                  domain::density.refusal(static_cast<double>(value)));
              }
              if (value == 0.0f) continue;
              is_empty = false;
              block.values[index_in_block({i, j, k}, corner)] = value;
            }
          }
        }
        if (!is_empty) grid.blocks.push_back(block);
      }
    }
  }
  return grid;
}

}  // namespace brume
