#include "core/scene/lights/sky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <thread>

#include "brume/at_time.h"
#include "brume/error.h"
#include "core/scene/atmosphere/clear_sky.h"
#include "core/scene/lights/environment.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/lights/radiance_map.h"

namespace brume {
namespace {

Scene under(const Sky& sky) {
  Scene scene;
  scene.environment.emplace().sky = sky;
  return scene;
}

const light::Directional& sun_of(const Scene& scene) {
  return std::get<light::Directional>(scene.lights.back().kind);
}

TEST(SceneSky, BecomesAMapAndALight) {
  Scene scene = under({.elevation = 30.0});
  scene.lights.emplace_back();
  scene.environment->intensity = 0.5;
  const Scene seen = evaluate_at(scene, 0.0);
  ASSERT_TRUE(seen.environment->map);
  EXPECT_FALSE(seen.environment->sky);
  ASSERT_EQ(seen.lights.size(), 2U);
  EXPECT_GT(seen.lights[1].intensity.r, 30.0);
  EXPECT_DOUBLE_EQ(sun_of(seen).angular_diameter, 0.53);
  // Once only.
  EXPECT_EQ(evaluate_at(seen, 0.0).lights.size(), 2U);
  EXPECT_EQ(scene.lights.size(), 1U);
}

TEST(SceneSky, IsWithoutItsSunIfSo) {
  EXPECT_TRUE(evaluate_at(under({.elevation = 30.0, .sun = false}), 0.0).lights.empty());
}

// The brightest pixel is below or above the sun, whatever turns both.
TEST(SceneSky, SunIsWhereTheSkyIsBrightest) {
  for (const double azimuth : {0.0, 90.0, 200.0}) {
    for (const double rotation : {0.0, 35.0}) {
      Scene scene = under({.elevation = 25.0, .azimuth = azimuth});
      scene.environment->rotation = rotation;
      const Scene seen = evaluate_at(scene, 0.0);
      const glm::dvec3 sun = to_light(sun_of(seen));
      const RadianceMap& map = *seen.environment->map;
      glm::dvec3 brightest(0.0);
      double most = 0.0;
      for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
          const glm::dvec3 direction =
              environment_rotation(*seen.environment) * map_direction(map, {x + 0.5, y + 0.5});
          const double green = environment_radiance(*seen.environment, direction).g;
          if (green > most) brightest = direction;
          most = std::max(most, green);
        }
      }
      const auto azimuth_of = [](const glm::dvec3& d) {
        return glm::normalize(glm::dvec2(d.x, d.z));
      };
      EXPECT_GT(glm::dot(azimuth_of(brightest), azimuth_of(sun)), std::cos(glm::radians(1.0)))
          << azimuth;
    }
  }
  const Scene east = evaluate_at(under({.elevation = 0.0, .azimuth = 90.0}), 0.0);
  EXPECT_NEAR(to_light(sun_of(east)).x, 1.0, 1e-12);
}

TEST(SceneSky, MapIsTheSky) {
  const Sky sky{.elevation = 12.0, .turbidity = 4.0};
  const Scene seen = evaluate_at(under(sky), 0.0);
  const ClearSky exact(sky.elevation, sky.turbidity, sky.ground_albedo);
  const RadianceMap& map = *seen.environment->map;
  for (const glm::ivec2 p : {glm::ivec2(256, 105), glm::ivec2(300, 30), glm::ivec2(400, 127),
                             glm::ivec2(10, 80), glm::ivec2(200, 126), glm::ivec2(20, 200)}) {
    const glm::dvec3 wanted = exact.radiance(map_direction(map, glm::dvec2(p) + 0.5));
    const glm::dvec3 pixel(map.pixel(p.x, p.y));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel[c], wanted[c], 0.005 * wanted[c]) << p.x;
  }
}

// The light of an animated sky is that of its values then; the sun stays a light when it has set.
TEST(SceneSky, FollowsItsKeyframes) {
  Scene scene = under({});
  auto& keys = scene.environment->sky->keys.elevation;
  keys.push_back({0.0, -10.0, Interpolation::linear});
  keys.push_back({1.0, 40.0, Interpolation::linear});
  EXPECT_TRUE(is_animated(scene));
  EXPECT_EQ(last_moment(scene), 1.0);
  const Scene night = evaluate_at(scene, 0.0);
  const Scene day = evaluate_at(scene, 1.0);
  ASSERT_EQ(night.lights.size(), 1U);
  EXPECT_EQ(night.lights[0].intensity, glm::dvec3(0.0));
  EXPECT_EQ(day.lights, evaluate_at(under({.elevation = 40.0}), 0.0).lights);
  EXPECT_EQ(day.environment->map, evaluate_at(under({.elevation = 40.0}), 0.0).environment->map);
}

// What is made of the map stays as long as nothing changes.
TEST(SceneSky, KeepsItsMap) {
  const Scene first = evaluate_at(under({.elevation = 33.0}), 0.0);
  const Scene again = evaluate_at(under({.elevation = 33.0, .azimuth = 40.0, .sun = false}), 0.0);
  EXPECT_EQ(first.environment->map, again.environment->map);
  EXPECT_NE(evaluate_at(under({.elevation = 33.5}), 0.0).environment->map, first.environment->map);
}

TEST(SceneSky, ThreadsShareOneMap) {
  std::array<std::shared_ptr<const RadianceMap>, 4> maps;
  {
    std::vector<std::jthread> threads;
    for (auto& map : maps) {
      threads.emplace_back(
          [&map] { map = evaluate_at(under({.elevation = 71.0}), 0.0).environment->map; });
    }
  }
  for (const auto& map : maps) EXPECT_EQ(map, maps[0]);
}

TEST(SceneSky, IsChecked) {
  Scene scene = under({.elevation = 91.0});
  EXPECT_THROW(check(scene), DomainError);
  scene = under({});
  scene.lights.resize(limits::lights);
  EXPECT_THROW(check(scene), DomainError);
  scene.environment->sky->sun = false;
  EXPECT_NO_THROW(check(scene));
  scene.environment->file = "/dawn.exr";
  EXPECT_THROW(check(scene), DomainError);
}

}  // namespace
}  // namespace brume
