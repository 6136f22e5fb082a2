#include "core/medium/splat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "brume/limits.h"

namespace brume {
namespace {

TEST(Splat, KeepsItsShapeAndHasTheMassOfItsBall) {
  Splat splat;
  splat.center = {1.0, -2.0, 3.0};
  splat.deviations = {0.7, 0.3, 0.1};
  splat.rotation = glm::normalize(glm::dquat(0.3, 0.5, -0.2, 0.7));
  splat.depth = 0.7;
  const Gaussian g = gaussian_of(splat);
  EXPECT_EQ(g.center, splat.center);
  EXPECT_LT(glm::length(g.radii() - std::sqrt(2.0) * splat.deviations), 1e-15);
  EXPECT_EQ(g.shape.rotation, splat.rotation);
  EXPECT_NEAR(g.mean_radius(), std::sqrt(2.0) * std::cbrt(0.021), 1e-15);
  EXPECT_NEAR(g.density * std::sqrt(std::numbers::pi) * g.mean_radius(), 0.7, 1e-15);
}

TEST(Splat, IsAsOpaqueAlongTheRadiusThatIsAskedFor) {
  Splat splat;
  splat.deviations = {0.7, 0.3, 0.1};
  splat.rotation = glm::normalize(glm::dquat(0.3, 0.5, -0.2, 0.7));
  splat.depth = 0.7;
  const auto depth_through = [](const Gaussian& g, double radius) {
    return g.density * std::sqrt(std::numbers::pi) * radius;
  };
  const auto with = [&](OpacityAlong along) { return gaussian_of(splat, along); };
  const double root = std::sqrt(2.0);
  EXPECT_NEAR(depth_through(with(OpacityAlong::shortest), 0.1 * root), 0.7, 1e-15);
  EXPECT_NEAR(depth_through(with(OpacityAlong::mean), std::cbrt(0.021) * root), 0.7, 1e-15);
  EXPECT_NEAR(depth_through(with(OpacityAlong::longest), 0.7 * root), 0.7, 1e-15);
  EXPECT_EQ(gaussian_of(splat), with(OpacityAlong::mean));
  // A thin one, by the radii that it has.
  splat.deviations = {1.0, 1.0, 0.0};
  EXPECT_NEAR(depth_through(with(OpacityAlong::shortest), limits::min_stretch * root), 0.7, 1e-15);
}

TEST(Splat, ThereAndBack) {
  Gaussian g{{1.0, -2.0, 3.0}, 1.0, 2.5};
  g.set_radii({0.2, 0.5, 0.3}, glm::normalize(glm::dquat(0.3, 0.5, -0.2, 0.7)));
  for (const auto along : {OpacityAlong::shortest, OpacityAlong::mean, OpacityAlong::longest}) {
    const Gaussian back = gaussian_of(splat_of(g, along), along);
    EXPECT_NEAR(back.density, g.density, 1e-14);
    EXPECT_LT(glm::length(back.radii() - g.radii()), 1e-15);
    EXPECT_EQ(back.shape.rotation, g.shape.rotation);
  }
}

TEST(Splat, RoundOnesAreBalls) {
  Splat splat;
  splat.deviations = glm::dvec3(0.4);
  splat.rotation = glm::normalize(glm::dquat(0.3, 0.5, -0.2, 0.7));
  EXPECT_TRUE(gaussian_of(splat).is_ball());
}

TEST(Splat, FlatOnesAreAsThickAsIsAllowed) {
  Splat splat;
  splat.deviations = {1.0, 1.0, 1e-9};
  EXPECT_EQ(gaussian_of(splat).shape.stretch, glm::dvec3(1.0, 1.0, limits::min_stretch));
}

}  // namespace
}  // namespace brume
