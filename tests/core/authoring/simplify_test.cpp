#include "core/authoring/simplify.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fog_bank.h"

namespace brume {
namespace {

TEST(Simplify, ErrorsAreAsEstimated) {
  std::size_t last = 3001;
  for (const double max_error : {0.01, 0.03, 0.1}) {
    const std::vector<Gaussian> bank = fog_bank(3000, 0.8, 5);
    const Simplified less = *simplify(medium_of(bank), {max_error});
    const std::vector<Gaussian> left = less.of(medium_of(bank));
    SCOPED_TRACE(testing::Message() << max_error << ": " << left.size());
    EXPECT_LT(left.size(), last);
    last = left.size();
    EXPECT_LE(less.error, max_error);
    EXPECT_NEAR(mass_of(left), mass_of(bank), 1e-9 * mass_of(bank));
    const double found = depth_error(bank, left, 400);
    EXPECT_LT(found, 1.5 * less.error + 1e-3);
    EXPECT_GT(found, 0.4 * less.error);
  }
  EXPECT_LT(last, 800u);
}

// Coincident ones cost nothing; those that stand alone are seen as they are.
TEST(Simplify, KeepsWhatStandsAlone) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 8; ++i) gaussians.push_back({{10.0 * i, 0.0, 0.0}, 1.0, 0.5});
  const Simplified same = *simplify(medium_of(gaussians), {0.1});
  EXPECT_TRUE(same.merged.empty());
  EXPECT_EQ(same.of(medium_of(gaussians)), gaussians);
  gaussians.push_back({{0.0, 0.0, 0.0}, 1.0, 0.25});
  const Simplified less = *simplify(medium_of(gaussians), {1e-3});
  EXPECT_EQ(less.kept, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7}));
  ASSERT_EQ(less.merged.size(), 1u);
  EXPECT_NEAR(less.merged[0].density, 0.75, 1e-12);
  EXPECT_NEAR(less.error, 0.0, 1e-6);
}

TEST(Simplify, MergesOnlyWhatIsAlike) {
  Gaussian plain{{0, 0, 0}, 1.0, 0.5};
  Gaussian grouped = plain;
  grouped.group = 3;
  Gaussian glowing = plain;
  glowing.optics.emission = {1, 0, 0};
  Gaussian dark = plain;
  dark.optics.albedo = glm::dvec3(0.5);
  for (const Gaussian& other : {grouped, glowing, dark}) {
    EXPECT_EQ(simplify(medium_of({plain, other}), {1.0})->kept.size(), 2u);
    const Simplified same = *simplify(medium_of({other, other}), {0.01});
    ASSERT_EQ(same.merged.size(), 1u);
    EXPECT_EQ(same.merged[0].optics, other.optics);
    EXPECT_EQ(same.merged[0].group, other.group);
  }
  const Simplified across = *simplify(medium_of({plain, grouped}), {0.01, true});
  ASSERT_EQ(across.merged.size(), 1u);
  EXPECT_EQ(across.merged[0].group, 0u);
}

TEST(Simplify, NothingOfNothing) {
  EXPECT_TRUE(simplify({}, {0.1})->of({}).empty());
  std::vector<Gaussian> empty(5, Gaussian{{1, 2, 3}, 0.5, 0.0});
  const Simplified less = *simplify(medium_of(empty), {0.1});
  EXPECT_EQ(mass_of(less.of(medium_of(empty))), 0.0);
  EXPECT_EQ(less.error, 0.0);
  // Far apart, and of sizes that differ much.
  const std::vector<Gaussian> far{
      {{-1e9, 0, 0}, 1e-6, 1.0}, {{1e9, 0, 0}, 1e6, 1e-6}, {{0, 0, 0}, 1, 1}};
  for (const Gaussian& g : simplify(medium_of(far), {0.5})->of(medium_of(far))) {
    EXPECT_TRUE(std::isfinite(g.radius) && std::isfinite(g.density) && g.radius > 0.0);
  }
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(simplify(medium_of(empty), {0.1}, stop.get_token()));
}

}  // namespace
}  // namespace brume
