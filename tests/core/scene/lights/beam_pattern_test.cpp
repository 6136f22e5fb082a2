#include "core/scene/lights/beam_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>

#include "core/scene/lights/light_falloff.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/materials/texture.h"
#include "tests/pictures.h"

namespace brume {
namespace {

Light spot_with(std::shared_ptr<const Texture> content) {
  light::Spot spot{.direction = {0.0, 0.0, -1.0}, .inner_angle = 30.0, .outer_angle = 30.0};
  spot.texture = {.file = "picture.png", .content = std::move(content)};
  return {.intensity = {2.0, 4.0, 8.0}, .kind = spot};
}

// What the lights of a spot send in a direction.
glm::dvec3 sent(const Light& light, const glm::dvec3& towards) {
  const glm::dvec3 w = glm::normalize(towards);
  glm::dvec3 sum(0.0);
  for (const PointLight& point : point_lights(light, {}, LightPoints::one)) {
    sum += point.falloff.at(w) * point.intensity;
  }
  return sum;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double bound) {
  EXPECT_LT(glm::length(a - b), bound) << a.x << " " << a.y << " " << a.z;
}

// As seen from a spot that shines ahead: x to the right, y up.
TEST(BeamPattern, IsUprightAheadOfTheSpot) {
  const Light light = spot_with(quadrants_picture());
  const double t = std::tan(glm::radians(30.0)) * 0.5;
  expect_near(sent(light, {-t, t, -1.0}), {2.0, 0.0, 0.0}, 0.01);   // red
  expect_near(sent(light, {t, t, -1.0}), {0.0, 4.0, 0.0}, 0.01);    // green
  expect_near(sent(light, {-t, -t, -1.0}), {0.0, 0.0, 8.0}, 0.01);  // blue
  expect_near(sent(light, {t, -t, -1.0}), {2.0, 4.0, 8.0}, 0.01);   // white
  expect_near(sent(light, {3.0 * t, 0.0, -1.0}), {0.0, 0.0, 0.0}, 1e-9);
  EXPECT_EQ(point_lights(light, {}, LightPoints::one).size(), 3u);
}

TEST(BeamPattern, TurnsCounterclockwiseAsSeenFromTheSpot) {
  Light light = spot_with(quadrants_picture());
  light.as<light::Spot>()->texture.rotation = 90.0;
  const double t = std::tan(glm::radians(30.0)) * 0.5;
  expect_near(sent(light, {-t, -t, -1.0}), {2.0, 0.0, 0.0}, 0.01);
}

TEST(BeamPattern, GrayIsOneLightAndBlurKeepsItsLight) {
  Light light = spot_with(disc_picture());
  const auto total = [&] {
    const auto patterns = beam_patterns(*light.as<light::Spot>());
    EXPECT_EQ(patterns.size(), 1u);
    const auto& values = patterns[0].map->values;
    return patterns[0].factor.x * std::accumulate(values.begin(), values.end(), 0.0);
  };
  const double sharp = total();
  const double edge = sent(light, {0.17, 0.0, -1.0}).x;
  light.as<light::Spot>()->texture.focus = 0.6;
  EXPECT_NEAR(total() / sharp, 1.0, 0.01);
  EXPECT_LT(sent(light, {0.0, 0.0, -1.0}).x, 2.0);
  EXPECT_NE(sent(light, {0.17, 0.0, -1.0}).x, edge);
  light.as<light::Spot>()->texture.focus = 0.0;
  const double in_middle = sent(light, {0.0, 0.0, -1.0}).x;
  EXPECT_GT(in_middle, 0.0);
  EXPECT_LT(sent(light, {0.5, 0.0, -1.0}).x, 0.2 * in_middle);
}

// The same texture gives the same map, so that nothing is uploaded again.
TEST(BeamPattern, IsKept) {
  const Light light = spot_with(quadrants_picture());
  const auto& spot = *light.as<light::Spot>();
  EXPECT_EQ(beam_patterns(spot)[0].map, beam_patterns(spot)[0].map);
}

}  // namespace
}  // namespace brume
