#include "brume/keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
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

// Surfaces that move and change.

glm::dquat about(const glm::dvec3& axis, double degrees) {
  return glm::angleAxis(glm::radians(degrees), glm::normalize(axis));
}

double degrees_between(const glm::dquat& a, const glm::dquat& b) {
  return glm::degrees(2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b)))));
}

TEST(RotationKeys, LinearTurnsEvenlyTheShortestWay) {
  const glm::dvec3 axis(1, 2, -1);
  for (const double sign : {1.0, -1.0}) {  // both quaternions of a rotation
    const Keys<glm::dquat> keys{
        {.time = 0.0, .value = about(axis, 10), .interpolation = Interpolation::linear},
        {.time = 2.0, .value = sign * about(axis, 130)}};
    for (double time = 0.0; time <= 2.0; time += 0.25) {
      EXPECT_LT(degrees_between(value_at(keys, time), about(axis, 10 + 60 * time)), 1e-5);
    }
  }
}

// The angle goes as that of numbers does: a turntable does not stop at each key.
TEST(RotationKeys, SmoothGoesOnThroughKeys) {
  Keys<glm::dquat> keys;
  Keys<double> angles;
  for (const double degrees : {0.0, 100.0, 230.0, 250.0, 400.0}) {
    const double time = 0.01 * degrees + static_cast<double>(keys.size());
    keys.push_back({.time = time, .value = about({0, 1, 0}, degrees)});
    angles.push_back({.time = time, .value = degrees});
  }
  for (double time = -1.0; time < 9.0; time += 0.05) {
    ASSERT_LT(degrees_between(value_at(keys, time), about({0, 1, 0}, value_at(angles, time))), 1e-5)
        << time;
  }
  const Keys<double> turned = turned_angles(keys);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_NEAR(turned[i].value, angles[i].value, 1e-9);
  }
}

TEST(RotationKeys, AreUnitAndMeetTheirKeys) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Keys<glm::dquat> keys;
  for (int i = 0; i < 8; ++i) {
    const glm::dquat q(normal(random), normal(random), normal(random), normal(random));
    keys.push_back({.time = 0.5 * i,
                    .value = i == 4 ? keys[3].value : glm::normalize(q),
                    .interpolation = static_cast<Interpolation>(i % 3)});
  }
  for (double time = -1.0; time < 5.0; time += 0.01) {
    ASSERT_NEAR(glm::length(value_at(keys, time)), 1.0, 1e-12);
  }
  for (const auto& key : keys) EXPECT_EQ(value_at(keys, key.time), key.value);
  EXPECT_EQ(value_at(keys, 1.75), keys[3].value);                      // the same twice
  EXPECT_EQ(value_at(keys, std::nextafter(1.5, 0.0)), keys[2].value);  // constant
}

TEST(SurfaceKeys, MoveAndChangeASurface) {
  Scene scene;
  scene.surfaces.resize(2);
  Surface& surface = scene.surfaces[1];
  surface.material.type = Material::Type::phong;
  surface.keys.translate = {{0.0, {0, 0, 0}}, {2.0, {4, 0, -2}}};
  surface.keys.rotate = {{0.0, about({0, 0, 1}, 0)}, {2.0, about({0, 0, 1}, 90)}};
  surface.keys.scale = {{0.0, 1.0}, {2.0, 3.0}};
  surface.keys.reflectance = {{0.0, glm::dvec3(0.0)}, {2.0, {1, 0.5, 0}}};
  surface.keys.specular = {{0.0, glm::dvec3(0.2)}, {2.0, glm::dvec3(0.0)}};
  surface.keys.exponent = {{0.0, 0.0}, {3.0, 100.0}};
  EXPECT_TRUE(is_animated(scene));
  EXPECT_EQ(last_moment(scene), 3.0);
  const Surface still = scene.surfaces[0];
  const Scene shown = evaluate_at(scene, 1.0);
  EXPECT_EQ(shown.surfaces[0], still);
  const Surface& moved = shown.surfaces[1];
  EXPECT_EQ(moved.translate, glm::dvec3(2, 0, -1));
  EXPECT_LT(degrees_between(moved.rotate, about({0, 0, 1}, 45)), 1e-5);
  EXPECT_EQ(moved.scale, 2.0);
  EXPECT_EQ(moved.material.reflectance, glm::dvec3(0.5, 0.25, 0));
  EXPECT_EQ(moved.material.specular, glm::dvec3(0.1));
  EXPECT_NEAR(moved.material.exponent, 100.0 * 7.0 / 27.0, 1e-12);  // 3 u^2 - 2 u^3 at 1/3
  EXPECT_EQ(moved.keys, SurfaceKeys{});
}

// Keyframes do not change values that a material does not have.
TEST(SurfaceKeys, OfAMeasuredMaterialAreThoseOfItsPlace) {
  Scene scene;
  scene.surfaces.resize(1);
  Surface& surface = scene.surfaces[0];
  surface.material.type = Material::Type::measured;
  surface.keys.reflectance = {{0.0, glm::dvec3(1.0)}};
  EXPECT_FALSE(has_keys(scene));
  surface.keys.translate = {{0.0, glm::dvec3(1.0)}};
  EXPECT_TRUE(has_keys(scene));
  EXPECT_EQ(evaluate_at(scene, 0.0).surfaces[0].material.reflectance, glm::dvec3(0.5));
}

// An overshoot of steep tangents is cut off: no surface reflects more than it gets.
TEST(SurfaceKeys, ReflectanceStaysBetweenZeroAndOne) {
  Scene scene;
  scene.surfaces.resize(1);
  scene.surfaces[0].keys.reflectance = {
      {.time = 0.0, .value = {0.9, 0.1, 0.5}, .out = glm::dvec3(20, -20, 0)},
      {.time = 1.0, .value = {0.9, 0.1, 0.5}, .in = glm::dvec3(-20, 20, 0)}};
  EXPECT_EQ(evaluate_at(scene, 0.5).surfaces[0].material.reflectance, glm::dvec3(1.0, 0.0, 0.5));
  scene.surfaces[0].keys.scale = {{.time = 0.0, .value = 1.0, .out = -100.0},
                                  {.time = 1.0, .value = 1.0}};
  EXPECT_GT(evaluate_at(scene, 0.3).surfaces[0].scale, 0.0);
}

}  // namespace

}  // namespace brume
