// Surfaces that move and change.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>
#include <random>

#include "brume/at_time.h"
#include "core/scene/animation/animation.h"

namespace brume {
namespace {

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
