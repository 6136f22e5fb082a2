#include "brume/density_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "brume/error.h"
#include "core/fit/fit_error.h"
#include "core/medium/gaussian_term.h"
#include "core/volume/block_tree.h"
#include "core/volume/medium_grid.h"
#include "tests/random.h"

namespace brume {
namespace {

TEST(DensityGrid, OfAnArrayHasItsValuesWhereTheyWere) {
  // No side is a multiple of a block's, and one block is empty.
  const glm::ivec3 size(9, 5, 20);
  std::vector<float> values(9 * 5 * 20);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = i % 20 < 16 ? static_cast<float>(i) : 0.0f;
  }
  const DensityGrid grid = grid_of(values, size, 0.5, {1.0, 2.0, 3.0});
  EXPECT_EQ(grid.blocks.size(), 4u);
  for (int x = 0; x < size.x; ++x) {
    for (int y = 0; y < size.y; ++y) {
      for (int z = 0; z < size.z; ++z) {
        const auto i = static_cast<std::size_t>((x * size.y + y) * size.z + z);
        EXPECT_EQ(grid.at({x, y, z}), static_cast<double>(values[i]));
      }
    }
  }
  EXPECT_EQ(grid.at({-1, 0, 0}), 0.0);
  EXPECT_EQ(grid.to_world({2, 0, 4}), glm::dvec3(2.0, 2.0, 5.0));
}

TEST(DensityGrid, OfAnArrayRefusesWhatIsNoDensity) {
  const auto refused = [](std::vector<float> values, const glm::ivec3& size, double spacing) {
    try {
      static_cast<void>(grid_of(values, size, spacing));
    } catch (const DomainError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused({0, 1, 2, -3}, {1, 2, 2}, 1.0),
            "values[0][1][1]: found -3; allowed: a number >= 0 (up to 1e12)");
  EXPECT_TRUE(refused({0, std::numeric_limits<float>::quiet_NaN()}, {2, 1, 1}, 1.0)
                  .starts_with("values[1][0][0]: found nan"));
  EXPECT_TRUE(refused({0, 1, 2}, {1, 2, 2}, 1.0).starts_with("values: found 3;"));
  EXPECT_TRUE(refused({}, {0, 0, 0}, 1.0).starts_with("values: found 0;"));
  EXPECT_TRUE(refused({}, {1 << 30, 1 << 30, 16}, 1.0).starts_with("values: found 0;"));
  EXPECT_TRUE(refused({0}, {1, 1, 1}, 0.0).starts_with("spacing: found 0;"));
  EXPECT_THROW(static_cast<void>(grid_of({{0.0f}}, {1, 1, 1}, 1.0, glm::dvec3(NAN))), DomainError);
}

Gaussian ellipsoid(Random& random, const glm::dvec3& radii) {
  Gaussian g{random.point(1.0), 1.0, 2.0};
  const glm::dvec3 q = random.point(1.0);
  g.set_radii(radii, glm::dquat(random.uniform(-1.0, 1.0), q.x, q.y, q.z));
  return g;
}

Medium medium_of(const Gaussian& gaussian) {
  Medium medium;
  medium.append(gaussian);
  return medium;
}

// Each voxel with a ten thousandth of the peak or more is in a block.
TEST(MediumSampling, HasAllOfAnEllipsoid) {
  constexpr double voxel = 0.1;
  constexpr int reach = 48;
  Random random(6);
  for (int n = 0; n < 12; ++n) {
    const Gaussian g = ellipsoid(
        random, {random.power(-1.5, 0.0), random.power(-1.5, 0.0), random.uniform(0.5, 1.0)});
    const Medium medium = medium_of(g);
    const auto plan = MediumSampling::plan(medium, voxel, 100'000);
    ASSERT_TRUE(plan);
    const DensityGrid grid = *plan->sample();
    const StandaloneTerm term(g);
    double sum = 0.0;
    for (int x = -reach; x <= reach; ++x) {
      for (int y = -reach; y <= reach; ++y) {
        for (int z = -reach; z <= reach; ++z) {
          const glm::dvec3 q = (*term).scaled(voxel * glm::dvec3(x, y, z));
          const double share = std::exp(-glm::dot(q, q));
          if (share > 1.01e-4) {
            const double found = grid.at({x, y, z});
            ASSERT_NEAR(found, 2.0 * share, 1e-5) << n << ' ' << x << ' ' << y << ' ' << z;
          }
          sum += share;
        }
      }
    }
    EXPECT_GT(sum, 0.5) << n;
  }
}

// A needle across the axes has few blocks of its box, and they are found without going through it.
TEST(MediumSampling, OfANeedleCostsItsLength) {
  Random random(7);
  for (int n = 0; n < 3; ++n) {
    const Gaussian g = ellipsoid(random, {1.0, 2e-4, 2e-4});
    const Medium medium = medium_of(g);
    const auto plan = MediumSampling::plan(medium, 1e-4, 1'000'000);
    ASSERT_TRUE(plan);
    const double length_in_blocks = 2.0 * 3.035 / (8e-4);
    EXPECT_GT(plan->blocks(), length_in_blocks);
    EXPECT_LT(plan->blocks(), 12.0 * length_in_blocks);
  }
}

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
