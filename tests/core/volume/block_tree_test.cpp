#include "core/volume/block_tree.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/fit/fit_error.h"
#include "tests/random.h"

namespace brume {
namespace {

// Blocks of a density of 1 at some multiples of 8.
DensityGrid some_blocks(int count, std::uint32_t seed) {
  Random random(seed);
  DensityGrid grid;
  for (int i = 0; i < count; ++i) {
    const glm::ivec3 corner = 8 * glm::ivec3(random.point(5.0));
    if (grid.find(corner)) continue;
    grid.blocks.push_back({corner, {}});
    grid.blocks.back().values.fill(1.0f);
    grid.sort();
  }
  return grid;
}

TEST(BlockTree, FindsAllDensityAlongALine) {
  const DensityGrid grid = some_blocks(100, 1);
  const BlockTree tree(grid.blocks);
  Random random(2);
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 p = random.point(50.0);
    const glm::dvec3 w =
        i % 4 == 0 ? glm::dvec3(0, 1, 0) : glm::normalize(random.point(1.0) - 1e-9);
    const auto intervals = tree.intervals(p, w);
    for (std::size_t k = 1; k < intervals.size(); ++k) {
      EXPECT_GT(intervals[k].begin, intervals[k - 1].end);
    }
    for (double t = -200.0; t < 200.0; t += 0.25) {
      const bool is_inside = std::ranges::any_of(intervals, [t](const auto& interval) {
        return t >= interval.begin && t <= interval.end;
      });
      if (grid.at(p + t * w) == 0.0) continue;
      EXPECT_TRUE(is_inside);
      ++hits;
    }
  }
  EXPECT_GT(hits, 1000);
}

// The integral along a line follows what lies on it.
TEST(BlockTree, IntervalsAreAsLongAsTheirBlocks) {
  DensityGrid grid = some_blocks(1, 1);
  grid.blocks.push_back(grid.blocks[0]);
  grid.blocks[1].corner.x += 1 << 24;
  const glm::dvec3 center = glm::dvec3(grid.blocks[0].corner) + 3.5;
  double length = 0.0;
  for (const auto& [begin, end] : BlockTree(grid.blocks).intervals(center, {1, 0, 0})) {
    length += end - begin;
  }
  EXPECT_EQ(length, 2 * 9.0);
}

// Lines are where the matter is, however large a stray voxel makes the box: none of its depth is
// found in no Gaussians.
TEST(DepthError, IsFoundBesideAStrayVoxel) {
  DensityGrid grid = some_blocks(60, 1);
  grid.blocks.push_back({glm::ivec3(1 << 24), {}});
  grid.blocks.back().values[0] = 1e-3f;
  EXPECT_EQ(depth_error(grid, {}, 2000), 1.0);
}

}  // namespace
}  // namespace brume
