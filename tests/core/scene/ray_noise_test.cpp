#include "core/scene/ray_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "brume/scene.h"
#include "tests/random.h"

namespace brume {
namespace {

Noise noise(double amplitude, double frequency, std::int64_t seed = 0) {
  return {.amplitude = amplitude, .frequency = frequency, .seed = seed};
}

glm::dvec3 direction(Random& random) {
  return glm::normalize(random.point(1.0));
}

// The derivative of the shift where its foot moves along `d`.
glm::dvec3 derivative(const RayNoise& n, const glm::dvec3& x, const glm::dvec3& w,
                      const glm::dvec3& d) {
  const double step = 1e-5;
  return (n.shift(x + step * d, w) - n.shift(x - step * d, w)) / (2.0 * step);
}

TEST(RayNoise, ShiftsByTheAmplitudeOnAverageAndNotInTheMean) {
  Random random(1);
  double square = 0.0;
  double max_shift = 0.0;
  glm::dvec3 mean(0.0);
  const int count = 200'000;
  for (int i = 0; i < count; ++i) {
    const RayNoise n(noise(0.3, 1.7, i / 100), 0.0);
    const glm::dvec3 w = direction(random);
    const glm::dvec3 shift = n.shift(random.point(50.0), w);
    ASSERT_NEAR(glm::dot(shift, w), 0.0, 1e-12);
    square += glm::dot(shift, shift);
    max_shift = std::max(max_shift, glm::length(shift));
    mean += shift;
  }
  EXPECT_NEAR(std::sqrt(square / count), 0.3, 0.002);
  EXPECT_LT(max_shift, 0.3 * RayNoise::max_shift);
  EXPECT_GT(max_shift, 0.5 * 0.3 * RayNoise::max_shift);
  EXPECT_LT(glm::length(mean) / count, 0.003);  // four standard errors
}

// The shift that keeps the mean optical depth.
TEST(RayNoise, HasNoDivergenceAcrossTheRay) {
  Random random(2);
  double max_slope = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const RayNoise n(noise(1.0, 1.3, i), 0.0);
    const glm::dvec3 x = random.point(9.0);
    const glm::dvec3 w = direction(random);
    const glm::dvec3 u = glm::normalize(glm::cross(w, random.point(1.0)));
    const glm::dvec3 v = glm::cross(w, u);
    const double along_u = glm::dot(u, derivative(n, x, w, u));
    const double along_v = glm::dot(v, derivative(n, x, w, v));
    ASSERT_NEAR(along_u + along_v, 0.0, 1e-6);
    max_slope = std::max(max_slope, std::abs(along_u));
  }
  EXPECT_GT(max_slope, 1.0);
}

TEST(RayNoise, RepeatsAfterItsPeriod) {
  Random random(3);
  const RayNoise n(noise(1.0, 0.5, 7), 0.0);
  const double period = RayNoise::period / 0.5;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 x = random.point(300.0);
    const glm::dvec3 w = direction(random);
    const glm::dvec3 shift = n.shift(x, w);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 farther = x;
      farther[axis] += period * (i % 5 - 2);
      ASSERT_LT(glm::length(n.shift(farther, w) - shift), 1e-11);
    }
    glm::dvec3 half = x;
    half[i % 3] += 0.5 * period;
    ASSERT_GT(glm::length(n.shift(half, w) - shift), 1e-6);
  }
}

// Across the faces of the lattice's cells, the end of a period among them.
TEST(RayNoise, HasContinuousDerivatives) {
  Random random(4);
  const RayNoise n(noise(1.0, 1.0, 7), 0.0);
  for (int i = 0; i < 1000; ++i) {
    glm::dvec3 x = random.point(70.0);
    const int axis = i % 3;
    x[axis] = i % 4 == 0 ? RayNoise::period : std::round(x[axis]);
    glm::dvec3 d(0.0);
    d[axis] = 1.0;
    const glm::dvec3 w = direction(random);
    ASSERT_LT(glm::length(n.shift(x - 1e-9 * d, w) - n.shift(x + 1e-9 * d, w)), 1e-7);
    // The second derivative is 50 or so.
    ASSERT_LT(glm::length(derivative(n, x - 2e-5 * d, w, d) - derivative(n, x + 2e-5 * d, w, d)),
              4e-3);
  }
}

TEST(RayNoise, IsSymmetricUnderReversal) {
  Random random(5);
  const RayNoise n(noise(1.0, 1.0), 0.0);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 x = random.point(9.0);
    const glm::dvec3 w = direction(random);
    ASSERT_LT(glm::length(n.shift(x, w) - n.shift(x, -w)), 1e-13);
  }
}

TEST(RayNoise, MovesWithTheWind) {
  Random random(6);
  Noise blown = noise(1.0, 2.0, -3);
  blown.velocity = {0.3, -0.1, 0.2};
  const RayNoise before(blown, 0.0);
  const RayNoise after(blown, 5.0);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 x = random.point(9.0);
    const glm::dvec3 w = direction(random);
    ASSERT_LT(glm::length(after.shift(x + 5.0 * blown.velocity, w) - before.shift(x, w)), 1e-12);
  }
}

TEST(RayNoise, SeedsDiffer) {
  const glm::dvec3 x(0.3, 0.4, 0.2);
  const glm::dvec3 w(0.0, 0.0, 1.0);
  const glm::dvec3 first = RayNoise(noise(1.0, 1.0, 0), 0.0).shift(x, w);
  for (const std::int64_t seed : {std::int64_t{1}, std::int64_t{-1}, std::int64_t{1} << 32}) {
    EXPECT_GT(glm::length(RayNoise(noise(1.0, 1.0, seed), 0.0).shift(x, w) - first), 1e-3) << seed;
  }
}

TEST(RayNoise, IsFiniteForAnyNumbers) {
  const double limit = std::numeric_limits<double>::max();
  for (const double amplitude : {1.0, limit}) {
    for (const double frequency : {0.0, 1e-300, 1e9, limit}) {
      for (const double time : {0.0, 1e9, limit}) {
        for (const double x : {0.0, -1e-300, 64.0, 1e15, -limit}) {
          Noise n = noise(amplitude, frequency);
          n.velocity = {1e9, -limit, 0.0};
          const glm::dvec3 shift = RayNoise(n, time).shift(glm::dvec3(x), {0.6, 0.0, 0.8});
          EXPECT_TRUE(std::isfinite(glm::dot(shift, shift)));
        }
      }
    }
  }
}

}  // namespace
}  // namespace brume
