#include "brume/keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "brume/at_time.h"
#include "core/scene/animation/animation.h"

namespace brume {
namespace {

TEST(Keys, AreConstantBeforeTheFirstAndAfterTheLast) {
  const Keys<double> one{{.time = 2.0, .value = 5.0}};
  for (const double time : {-1.0, 2.0, 3.0}) EXPECT_EQ(value_at(one, time), 5.0);
  const Keys<double> two{{.time = 1.0, .value = 3.0}, {.time = 2.0, .value = 4.0}};
  EXPECT_EQ(value_at(two, 0.0), 3.0);
  EXPECT_EQ(value_at(two, 1.0), 3.0);
  EXPECT_EQ(value_at(two, 2.0), 4.0);
  EXPECT_EQ(value_at(two, 9.0), 4.0);
}

TEST(Keys, LinearIsLinearAndSmoothEasesInAndOut) {
  Keys<double> keys{{.time = 1.0, .value = 2.0, .interpolation = Interpolation::linear},
                    {.time = 3.0, .value = 6.0}};
  EXPECT_DOUBLE_EQ(value_at(keys, 1.5), 3.0);
  keys[0].interpolation = Interpolation::smooth;
  EXPECT_DOUBLE_EQ(value_at(keys, 2.0), 4.0);
  EXPECT_DOUBLE_EQ(value_at(keys, 1.5), 2.0 + 4.0 * (3.0 / 16.0 - 2.0 / 64.0));  // 3 u^2 - 2 u^3
}

// The slopes by hand, from the weighted harmonic mean of the chords: at the second key the chords 1
// over a length of 1 and 6 over 0.5 have the weights 2 and 2.5, at the third 6 over 0.5 and 0.4
// over 2.5 have 5.5 and 3.5; at the fourth, an extremum, it is 0.
TEST(Keys, SmoothHasTheSlopesOfFritschAndButland) {
  Keys<double> keys;
  const double times[]{0.0, 1.0, 1.5, 4.0, 5.0};
  const double values[]{0.0, 1.0, 4.0, 5.0, 2.0};
  const double slopes[]{0.0, 54.0 / 29.0, 27.0 / 29.0, 0.0, 0.0};
  for (int k = 0; k < 5; ++k) keys.push_back({.time = times[k], .value = values[k]});
  constexpr double h = 1e-6;  // so that the second derivative, below 100, makes up for 1e-4
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR((value_at(keys, times[k]) - value_at(keys, times[k] - h)) / h, slopes[k], 1e-4);
    EXPECT_NEAR((value_at(keys, times[k] + h) - value_at(keys, times[k])) / h, slopes[k], 1e-4);
  }
}

TEST(Keys, SmoothNeverLeavesTheIntervalOfItsKeysAndHasNoKinks) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int round = 0; round < 200; ++round) {
    Keys<double> keys;
    double time = -3.0;
    double max_value = 0.0;
    for (int k = 0; k < 6; ++k) {
      time += 0.05 + uniform(random);
      // Many zeros: a density that comes and goes.
      keys.push_back({.time = time, .value = uniform(random) < 0.4 ? 0.0 : uniform(random)});
      max_value = std::max(max_value, keys.back().value);
    }
    double before = value_at(keys, -3.0);
    double slope_before = 0.0;
    constexpr double step = 1e-3;
    for (double t = -3.0 + step; t < time + 0.5; t += step) {
      const double value = value_at(keys, t);
      ASSERT_GE(value, 0.0);
      const auto next = std::upper_bound(keys.begin(), keys.end(), t,
                                         [](double at, const auto& key) { return at < key.time; });
      if (next != keys.begin() && next != keys.end()) {
        const auto [min_value, limit] = std::minmax((next - 1)->value, next->value);
        ASSERT_GE(value, min_value);
        ASSERT_LE(value, limit);
      }
      // A second derivative is at most some 24 values over the square of the least distance.
      const double slope = (value - before) / step;
      ASSERT_LT(std::abs(slope - slope_before), 30.0 * max_value / (0.05 * 0.05) * step + 1e-9);
      before = value;
      slope_before = slope;
    }
  }
}

TEST(Keys, VectorsGoByComponents) {
  const Keys<glm::dvec3> keys{{.time = 0.0, .value = {0, 1, 2}}, {.time = 2.0, .value = {4, 1, 0}}};
  EXPECT_EQ(value_at(keys, 1.0), glm::dvec3(2, 1, 1));
}

// Against sums of a hundred thousand values; begin and end before, between, at and after the keys.
TEST(Keys, IntegralsAreSumsOfValues) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int round = 0; round < 10; ++round) {
    Keys<glm::dvec3> keys;
    double time = -1.0;
    for (int k = 0; k < 5; ++k) {
      time += 0.05 + uniform(random);
      keys.push_back({.time = time,
                      .value = {uniform(random), uniform(random) - 0.5, 0.0},
                      .interpolation = static_cast<Interpolation>(k % 2)});
    }
    for (const auto& [begin, end] : {std::pair(-3.0, 9.0), std::pair(0.3, -0.2),
                                     std::pair(keys[1].time, keys[3].time), std::pair(8.0, 9.0)}) {
      constexpr int count = 100'000;
      glm::dvec3 sum(0.0);
      for (int k = 0; k < count; ++k) {
        sum += value_at(keys, std::lerp(begin, end, (k + 0.5) / count)) * (end - begin) / 1e5;
      }
      const glm::dvec3 exact = integral(keys, begin, end);
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(exact[k], sum[k], 1e-7);
    }
  }
}

TEST(Keys, AreSortedAndReplaceKeysOfTheSameTime) {
  Keys<double> keys;
  for (const double time : {2.0, 0.0, 1.0}) set_key(keys, {.time = time, .value = time});
  set_key(keys, {.time = 1.0 + 1e-9, .value = 7.0});
  ASSERT_EQ(keys.size(), 3u);
  EXPECT_EQ(keys[1].value, 7.0);
  EXPECT_EQ(find_key(keys, 2.0), keys.end() - 1);
  EXPECT_EQ(find_key(keys, 1.5), keys.end());
}

TEST(Animation, EvaluatesTheSceneAtATime) {
  Scene scene;
  scene.medium.set_homogeneous_density(0.5);
  scene.lights.resize(2);
  scene.environment.emplace();
  Scene still = scene;
  EXPECT_FALSE(is_animated(scene));
  still.time = 3.0;
  EXPECT_EQ(evaluate_at(scene, 3.0), still);

  const auto vectors = [](const glm::dvec3& a, const glm::dvec3& b) {
    return Keys<glm::dvec3>{{.time = 0.0, .value = a}, {.time = 2.0, .value = b}};
  };
  const auto numbers = [](double a, double b) {
    return Keys<double>{{.time = 0.0, .value = a}, {.time = 2.0, .value = b}};
  };
  scene.camera_keys.eye = vectors({0, 0, 4}, {0, 2, 4});
  scene.camera_keys.target = vectors({0, 0, 0}, {2, 0, 0});
  scene.camera_keys.vertical_fov = numbers(40, 60);
  scene.density_keys = numbers(0.0, 0.2);
  scene.optics.keys.albedo = vectors({1, 1, 1}, {0.5, 1, 1});
  scene.optics.keys.anisotropy = numbers(0.0, 0.8);
  scene.optics.noise.keys.amplitude = numbers(0.0, 1.0);
  scene.lights[1].keys.position = vectors({0, 0, 0}, {0, 4, 0});
  scene.lights[1].keys.intensity = vectors({8, 0, 0}, {0, 8, 0});
  scene.environment->keys.intensity = numbers(1.0, 3.0);
  scene.environment->keys.rotation = numbers(0.0, 90.0);
  EXPECT_TRUE(is_animated(scene));

  Scene middle = still;  // every smooth key pair is half way at half the time
  middle.time = 1.0;
  middle.camera = {{0, 1, 4}, {1, 0, 0}, {0, 1, 0}, 50.0};
  middle.medium.set_homogeneous_density(0.1);
  middle.optics.albedo = {0.75, 1, 1};
  middle.optics.anisotropy = 0.4;
  middle.optics.noise.amplitude = 0.5;
  middle.lights[1].position = {0, 2, 0};
  middle.lights[1].intensity = {4, 4, 0};
  middle.environment->intensity = 2.0;
  middle.environment->rotation = 45.0;
  EXPECT_EQ(evaluate_at(scene, 1.0), middle);
}

TEST(Animation, NoiseMovesWithTheWindOnly) {
  Scene scene;
  scene.optics.noise.amplitude = 0.5;
  EXPECT_FALSE(is_animated(scene));
  scene.optics.noise.velocity = {0, 0, 1};
  EXPECT_TRUE(is_animated(scene));
  scene.optics.noise.amplitude = 0.0;
  EXPECT_FALSE(is_animated(scene));
}

// Noise is at frequency * (x - velocity * time): with keyframes the product is the way of the wind.
TEST(Animation, WindWithKeyframesHasNoJumps) {
  Scene scene;
  Noise& noise = scene.optics.noise;
  noise.keys.velocity = {{.time = 1.0, .value = {2, 0, 0}, .interpolation = Interpolation::linear},
                         {.time = 3.0, .value = {0, 0, 4}}};
  noise.keys.frequency = {{.time = 0.0, .value = 1.0}, {.time = 2.0, .value = 3.0}};
  const auto way = [&](double time) {
    return evaluate_at(scene, time).optics.noise.velocity * time;
  };
  const auto expect_near = [](const glm::dvec3& a, const glm::dvec3& b) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-12);
  };
  expect_near(way(0.5), {1, 0, 0});
  expect_near(way(2.0), {2.0 + 1.5, 0, 1});
  expect_near(way(4.0), {4, 0, 8});
  expect_near(way(-1.0), {-2, 0, 0});
  EXPECT_EQ(evaluate_at(scene, 0.0).optics.noise.velocity, glm::dvec3(2, 0, 0));
  EXPECT_EQ(evaluate_at(scene, 1.0).optics.noise.frequency, 2.0);
}

TEST(Animation, KeepsEyeAndTargetApart) {
  Scene scene;
  scene.camera_keys.eye = {{.time = 0.0, .value = {1e12, 0, 0}},
                           {.time = 2.0, .value = {1e12, 0, 4}}};
  scene.camera_keys.target = {{.time = 0.0, .value = {1e12, 0, 4}},
                              {.time = 2.0, .value = {1e12, 0, 0}}};
  const Camera camera = evaluate_at(scene, 1.0).camera;
  EXPECT_LT(camera.target.z, camera.eye.z);
}

}  // namespace
}  // namespace brume
