#include "core/scene/lights/light_falloff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>
#include <random>

#include "core/scene/lights/beam_pattern.h"
#include "core/scene/lights/photometric_profile.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/materials/texture.h"
#include "tests/pictures.h"

namespace brume {
namespace {

glm::dvec3 at_angle(double degrees) {
  return {std::sin(glm::radians(degrees)), -std::cos(glm::radians(degrees)), 0.0};
}

TEST(LightFalloff, FollowsTheFormulaOfGltf) {
  const LightFalloff spot(light::Spot{{0.0, -7.0, 0.0}, 10.0, 30.0});
  const double dark = std::cos(glm::radians(30.0));
  const double full = std::cos(glm::radians(10.0));
  for (const double angle : {0.0, 5.0, 9.9}) EXPECT_EQ(spot.at(at_angle(angle)), 1.0) << angle;
  for (const double angle : {12.0, 20.0, 29.0}) {
    const double share = (std::cos(glm::radians(angle)) - dark) / (full - dark);
    EXPECT_NEAR(spot.at(at_angle(angle)), share * share, 1e-12) << angle;
  }
  for (const double angle : {30.1, 90.0, 180.0}) EXPECT_EQ(spot.at(at_angle(angle)), 0.0) << angle;
}

// cos a - cos b of angles in degrees, by sines, which keep the digits of narrow cones.
double cosine_difference(double a, double b) {
  return 2.0 * std::sin(glm::radians(0.5 * (b - a))) * std::sin(glm::radians(0.5 * (b + a)));
}

TEST(LightFalloff, IsFullOnTheAxisOfNarrowCones) {
  for (const auto& [inner, outer] :
       {std::pair{2.9, 3.0}, {1.5, 1.9}, {0.5, 1.0}, {0.4, 0.5}, {0.02, 0.05}, {0.005, 0.006}}) {
    const LightFalloff spot(light::Spot{{0.0, -1.0, 0.0}, inner, outer});
    EXPECT_EQ(spot.at(at_angle(0.0)), 1.0) << outer;
    EXPECT_EQ(spot.at(at_angle(0.99 * inner)), 1.0) << outer;
    const double middle = 0.5 * (inner + outer);
    const double share = cosine_difference(middle, outer) / cosine_difference(inner, outer);
    EXPECT_NEAR(spot.at(at_angle(middle)), share * share, 1e-6) << outer;
    EXPECT_EQ(spot.at(at_angle(1.01 * outer)), 0.0) << outer;
  }
}

TEST(LightFalloff, HasAHardEdgeWhereItsAnglesAreEqual) {
  for (const double angle : {0.2, 1.0, 45.0, 90.0, 170.0}) {
    const LightFalloff spot(light::Spot{{0.0, -1.0, 0.0}, angle, angle});
    EXPECT_EQ(spot.at(at_angle(0.999 * angle)), 1.0) << angle;
    EXPECT_EQ(spot.at(at_angle(1.001 * angle)), 0.0) << angle;
  }
}

TEST(LightFalloff, IsOneWithoutCone) {
  const LightFalloff none;
  EXPECT_TRUE(none.is_isotropic());
  EXPECT_EQ(none.at({0.6, 0.8, 0.0}), 1.0);
  // Full up to where the cone closes behind the light.
  const LightFalloff all(light::Spot{{1e-200, 0.0, 0.0}, 179.0, 180.0});
  EXPECT_FALSE(all.is_isotropic());
  for (const double angle : {0.0, 60.0, 120.0}) EXPECT_EQ(all.at(at_angle(angle)), 1.0) << angle;
}

// Every state that keyframes pass through is a light.
TEST(LightFalloff, SurvivesNoDirectionAndClosedCones) {
  EXPECT_EQ(LightFalloff(light::Spot{glm::dvec3(0.0), 10.0, 20.0}).at({0.0, -1.0, 0.0}), 1.0);
  EXPECT_EQ(LightFalloff(light::Spot{{0.0, -1e308, 1e308}, 0.0, 1e-9}).at({1.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(LightFalloff(light::Spot{{0.0, -1.0, 0.0}, 50.0, 20.0}).at(at_angle(10.0)), 1.0);
}

// Between neighbouring edges the falloff along a line is 0, 1, or on the slope.
TEST(LightFalloff, IsTheSameByTheMapOfAProfile) {
  light::Spot spot;
  spot.direction = glm::dvec3(0.3, -1.0, 0.2);
  spot.outer_angle = 70.0;
  spot.profile.content = std::make_shared<const PhotometricProfile>(
      std::vector<double>{0.0, 45.0, 90.0, 180.0}, std::vector<double>{0.0, 90.0, 360.0},
      std::vector<double>{1.0, 3.0, 2.0, 0.5, 1.0, 0.5, 2.0, 1.0, 1.0, 3.0, 2.0, 0.5});
  const LightFalloff falloff(spot);
  std::mt19937 engine(3);
  const auto uniform = [&] { return static_cast<double>(engine()) / 2147483648.0 - 1.0; };
  for (int i = 0; i < 1000; ++i) {
    const double x = uniform();
    const double y = uniform();
    const glm::dvec3 w = glm::normalize(glm::dvec3(x, y, uniform()));
    EXPECT_NEAR(falloff.by_map(w), falloff.at(w), 5e-3);
  }
}

TEST(LightFalloff, EdgesPartALine) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return glm::dvec3(uniform(random), uniform(random), uniform(random)); };
  int crossed = 0;
  for (int i = 0; i < 500; ++i) {
    const double outer = 90.0 * (uniform(random) + 1.0);
    const LightFalloff spot(light::Spot{vector(), 0.6 * outer, outer});
    const glm::dvec3 light = vector();
    const glm::dvec3 origin = vector();
    const glm::dvec3 w = glm::normalize(vector());
    const auto edges = spot.edges(light, origin, w);
    const auto kind = [&](double t) {
      const double falloff = spot.at(glm::normalize(origin + t * w - light));
      return falloff <= 0.0 ? 0 : falloff >= 1.0 ? 2 : 1;
    };
    double begin = -50.0;
    for (std::size_t k = 0; k <= edges.size(); ++k) {
      const double end = k < edges.size() ? std::clamp(edges[k], begin, 50.0) : 50.0;
      const double width = end - begin;
      if (width > 1e-6) {
        const int middle = kind(begin + 0.5 * width);
        for (const double share : {0.001, 0.2, 0.8, 0.999}) {
          EXPECT_EQ(kind(begin + share * width), middle) << i;
        }
        crossed += k > 0 ? 1 : 0;
      }
      begin = end;
    }
  }
  EXPECT_GT(crossed, 500);
}

Light spot_with(std::shared_ptr<const Texture> content) {
  light::Spot spot{.direction = {0.0, 0.0, -1.0}, .inner_angle = 30.0, .outer_angle = 30.0};
  spot.texture = {.file = "picture.png", .content = std::move(content)};
  return {.intensity = {2.0, 4.0, 8.0}, .kind = spot};
}

// The intensity of a spot in a direction.
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

// A spot that shines ahead sees x to the right, y up.
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
