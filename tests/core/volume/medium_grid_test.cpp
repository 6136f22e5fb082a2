#include "core/volume/medium_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/medium/gaussian_term.h"
#include "tests/random.h"

namespace brume {
namespace {

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

}  // namespace
}  // namespace brume
