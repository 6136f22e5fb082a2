// Densities, depths and collisions of random walks against the medium's own closed forms.

#include "render/paths/path_medium.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/math/infinity.h"
#include "render/paths/camera_ray.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

constexpr double tolerance = 1e-9;

glm::dvec3 direction(Random& random) {
  while (true) {
    const glm::dvec3 p = random.point(1.0);
    const double length = glm::length(p);
    if (length > 0.1 && length <= 1.0) return p / length;
  }
}

// Few are in one group, many in many clusters of groups.
class PathMediumOf : public testing::TestWithParam<int> {};

TEST_P(PathMediumOf, SumsDensitiesAndDepths) {
  const MediumIndex index(cloud_scene(GetParam(), 5.0).medium, tolerance);
  const PathMedium medium(index);
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 x = random.point(1.6);
    // Either leaves out what is below the tolerance; the index asks it of segments.
    EXPECT_NEAR(medium.density(x), index.density(x), 1e-6 * (1.0 + index.density(x)));
    const glm::dvec3 w = direction(random);
    for (const double length : {1e-3, 0.4, 3.0, infinity}) {
      const double depth = index.depth({x, w, length});
      EXPECT_NEAR(medium.depth(x, w, length), depth, 1e-9 * (1.0 + depth)) << length;
    }
  }
  EXPECT_EQ(medium.depth({100, 0, 0}, {1, 0, 0}, infinity), 0.0);
}

TEST_P(PathMediumOf, MajorantsBoundDensities) {
  const MediumIndex index(cloud_scene(GetParam(), 5.0).medium, tolerance);
  const PathMedium medium(index);
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 origin = random.point(3.0);
    const glm::dvec3 w = i % 10 == 0 ? glm::dvec3(0, i % 20 == 0 ? 1 : -1, 0) : direction(random);
    MajorantGrid::Walk walk(medium.grid(), origin, w, 10.0);
    double last = walk.enter();
    double bound = 0.0;
    for (; walk.in_cell(); walk.next()) {
      ASSERT_NEAR(walk.enter(), last, 1e-9);
      ASSERT_GE(walk.exit(), walk.enter());
      for (const double f : {1e-9, 0.3, 0.7, 1.0 - 1e-9}) {
        const double t = std::lerp(walk.enter(), walk.exit(), f);
        ASSERT_LE(index.density(origin + t * w), walk.majorant() + 1e-6);
      }
      bound += walk.majorant() * (walk.exit() - walk.enter());
      last = walk.exit();
    }
    // Nothing lies outside the cells, and what they allow is not wasteful: across a cell of a fifth
    // of a radius a Gaussian falls to half at most.
    const double depth = medium.depth(origin, w, 10.0);
    EXPECT_GE(bound, depth * (1.0 - 1e-9));
    EXPECT_LT(bound, 2.5 * depth + 0.3);
  }
}

INSTANTIATE_TEST_SUITE_P(Gaussians, PathMediumOf, testing::Values(1, 30, 400, 5000));

// Checks of many collisions how many get through, and how the others lie along the ray in depth.
void expect_exponential(const PathMedium& medium, const glm::dvec3& origin, const glm::dvec3& w,
                        double length) {
  const double opacity = -std::expm1(-medium.depth(origin, w, length));
  constexpr int count = 20'000;
  std::array<int, 10> bins{};
  int passed = 0;
  for (int i = 0; i < count; ++i) {
    PathRandom random(1, 0, static_cast<std::uint64_t>(i), 0);
    const double t = medium.collision(origin, w, length, random);
    if (t == infinity) {
      ++passed;
      continue;
    }
    ASSERT_GE(t, 0.0);
    ASSERT_LE(t, length);
    const double u = -std::expm1(-medium.depth(origin, w, t)) / opacity;
    ++bins[std::min(static_cast<std::size_t>(10.0 * u), bins.size() - 1)];
  }
  EXPECT_NEAR(passed, count * (1.0 - opacity), 4.0 * std::sqrt(count * opacity * (1.0 - opacity)));
  double chi_square = 0.0;
  const double expected = (count - passed) / 10.0;
  for (const int bin : bins) chi_square += (bin - expected) * (bin - expected) / expected;
  EXPECT_LT(chi_square, 9.0 + 4.0 * std::sqrt(18.0));
}

TEST(PathMedium, CollisionsFollowTheOpticalDepth) {
  const MediumIndex index(cloud_scene(30, 2.0).medium, tolerance);
  const PathMedium medium(index);
  expect_exponential(medium, {0, 0, 4}, {0, 0, -1}, infinity);
  expect_exponential(medium, {0.1, -0.2, 0.3}, glm::normalize(glm::dvec3(1, 2, 0.5)), infinity);
  expect_exponential(medium, {0.1, -0.2, 0.3}, glm::normalize(glm::dvec3(1, 2, 0.5)), 0.4);
}

// A cell's majorant says nothing where the Gaussian in it is much smaller: found by depth.
TEST(PathMedium, CollisionsInTinyDenseGaussiansFollowTheOpticalDepth) {
  Medium tiny;
  tiny.append({{0, 0, 0}, 1e-5, 1e5});
  tiny.append({{1, 0, 0}, 1e-5, 3e4});
  tiny.append({{0.5, 0, 0}, 1.0, 0.3});
  const MediumIndex index(tiny, tolerance);
  const PathMedium medium(index);
  expect_exponential(medium, {-5, 0, 0}, {1, 0, 0}, infinity);
}

TEST(PathMedium, AnEmptyMediumHasNoCollisions) {
  const MediumIndex index(Medium{}, tolerance);
  const PathMedium medium(index);
  PathRandom random(1, 2, 3, 4);
  EXPECT_EQ(medium.collision({0, 0, 0}, {1, 0, 0}, infinity, random), infinity);
  EXPECT_EQ(medium.density({0, 0, 0}), 0.0);
  EXPECT_EQ(medium.depth({0, 0, 0}, {1, 0, 0}, infinity), 0.0);
}

TEST(CameraRay, InvertsItsDepth) {
  for (const double b0 : {0.0, 0.02, 3.0}) {
    for (const double length : {0.5, 4.0, 30.0, infinity}) {
      for (const double amplitude : {0.0, 0.4}) {
        Scene scene = in_fog(cloud_scene(12, 3.0), b0);
        scene.optics.noise.amplitude = amplitude;
        MediumIndex index(scene.medium, tolerance);
        index.set_noise(RayNoise(scene.optics.noise, 0.0));
        const CameraRay ray(index, {0, 0, 4}, glm::normalize(glm::dvec3(0.05, 0.02, -1)), length);
        if (!(ray.depth() > 0.0)) continue;
        for (const double u : {1e-12, 0.01, 0.3, 0.7, 0.99, 1.0 - 1e-12}) {
          const double level = -std::log1p(u * std::expm1(-ray.depth()));
          const CameraRay::Point point = ray.at_depth(level);
          ASSERT_TRUE(std::isfinite(point.t));
          ASSERT_GE(point.t, 0.0);
          ASSERT_LE(point.t, length);
          // 1 - 1e-12 may lie past what is visible.
          ASSERT_NEAR(point.depth, level, 2e-9 * ray.depth() + 1e-9 * level) << u;
        }
      }
    }
  }
}

}  // namespace
}  // namespace brume
