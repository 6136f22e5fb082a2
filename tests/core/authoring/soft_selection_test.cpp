#include "core/authoring/soft_selection.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/math/random_source.h"

namespace brume {
namespace {

TEST(SoftSelection, WeighsByTheDistanceToTheNearest) {
  Medium medium;
  RandomSource random(4);
  for (int i = 0; i < 300; ++i) medium.append({3.0 * random.in_ball(), 0.1, 1.0});
  const std::vector<GaussianId> ids(medium.ids().begin(), medium.ids().begin() + 20);
  constexpr double radius = 0.7;
  std::vector<SoftMember> expected;
  for (std::size_t i = 20; i < medium.size(); ++i) {
    double nearest = 1e9;
    for (std::size_t k = 0; k < 20; ++k) {
      nearest = std::min(nearest, glm::distance(medium.centers()[i], medium.centers()[k]));
    }
    const double t = nearest / radius;
    if (t < 1.0) expected.push_back({i, (1.0 - t) * (1.0 - t) * (1.0 + 2.0 * t)});
  }
  EXPECT_GT(expected.size(), 20u);
  EXPECT_LT(expected.size(), 260u);
  EXPECT_EQ(soft_members(medium, ids, radius), expected);
}

TEST(SoftSelection, IsFarFromAnywhere) {
  Medium medium;
  medium.append({{1e12, 0.0, 0.0}, 1.0, 1.0});
  medium.append({{-1e12, 5.0, 0.0}, 1.0, 1.0});
  const std::vector<GaussianId> ids{medium.ids()[0]};
  EXPECT_TRUE(soft_members(medium, ids, 1e-9).empty());
  EXPECT_TRUE(soft_members(medium, {}, 1.0).empty());
}

}  // namespace
}  // namespace brume
