#include "core/scene/lights/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <thread>

#include "brume/at_time.h"
#include "brume/error.h"
#include "core/math/sphere_rule.h"
#include "core/scene/atmosphere/clear_sky.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/lights/radiance_map.h"
#include "tests/random.h"

namespace brume {
namespace {

RadianceMap random_map(unsigned seed, int width, int height) {
  Random random(seed);
  RadianceMap map{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    map.pixels.emplace_back(random.point(1.0) + glm::dvec3(1.0));
  }
  return map;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double error) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], error);
}

TEST(RadianceMap, MatchesTheFormatsOrientation) {
  const RadianceMap map{8, 4, std::vector<glm::vec3>(32)};
  expect_near(map_direction(map, {3, 0}), {0, 1, 0}, 1e-15);   // the top row looks up
  expect_near(map_direction(map, {4, 2}), {0, 0, -1}, 1e-15);  // the middle along -z
  expect_near(map_direction(map, {6, 2}), {1, 0, 0}, 1e-15);   // the right half is +x
  expect_near(map_direction(map, {2, 2}), {-1, 0, 0}, 1e-15);
  Random random(7);
  for (int n = 0; n < 100; ++n) {
    const glm::dvec3 d = glm::normalize(random.point(1.0));
    expect_near(map_direction(map, map_position(map, d)), d, 1e-14);
  }
}

TEST(RadianceMap, IsBilinearAndClosesAround) {
  const RadianceMap map = random_map(8, 8, 4);
  const auto at = [&](double x, double y) { return map_radiance(map, map_direction(map, {x, y})); };
  const auto pixel = [&](int x, int y) { return glm::dvec3(map.pixel(x, y)); };
  expect_near(at(2.5, 1.5), pixel(2, 1), 1e-12);
  expect_near(at(3.0, 2.0), 0.25 * (pixel(2, 1) + pixel(3, 1) + pixel(2, 2) + pixel(3, 2)), 1e-12);
  expect_near(at(0.0, 1.5), 0.5 * (pixel(7, 1) + pixel(0, 1)), 1e-12);
  expect_near(at(8.0 - 1e-9, 1.5), 0.5 * (pixel(7, 1) + pixel(0, 1)), 1e-8);
  const RadianceMap one = random_map(9, 1, 1);
  expect_near(map_radiance(one, glm::dvec3(0, -1, 0)), glm::dvec3(one.pixel(0, 0)), 1e-12);
}

TEST(RadianceMap, SinglePrecisionMatchesDouble) {
  const RadianceMap map = random_map(256, 128, 2);
  Random random(3);
  for (int n = 0; n < 1000; ++n) {
    const glm::vec3 d(glm::normalize(random.point(1.0)));
    expect_near(glm::dvec3(map_radiance(map, d)), map_radiance(map, glm::dvec3(d)), 1e-3);
  }
}

TEST(RadianceMap, ConstantRadianceHasOnlyTheFirstCoefficient) {
  const RadianceMap map{16, 8, std::vector<glm::vec3>(128, glm::vec3(1.0f, 2.0f, 0.5f))};
  const ShVector<glm::dvec3> sh = map_sh(map, 6);
  expect_near(sh[0], std::sqrt(4 * std::numbers::pi) * glm::dvec3(1, 2, 0.5), 1e-12);
  for (std::size_t i = 1; i < sh.size(); ++i) expect_near(sh[i], glm::dvec3(0), 1e-12);
}

TEST(RadianceMap, ProjectionIsTheIntegralOverThePixels) {
  // One bright pixel at a time, integrated by a fine midpoint rule.
  RadianceMap map{6, 3, std::vector<glm::vec3>(18)};
  for (const glm::ivec2 at : {glm::ivec2(4, 0), glm::ivec2(0, 1), glm::ivec2(2, 2)}) {
    std::fill(map.pixels.begin(), map.pixels.end(), glm::vec3(0));
    map.pixels[static_cast<std::size_t>(at.y * 6 + at.x)] = glm::vec3(1.0f);
    ShVector<double> sum(6);
    constexpr int n = 200;
    for (int i = 0; i < n * n; ++i) {
      const glm::dvec2 position = glm::dvec2(at) + (glm::dvec2(i % n, i / n) + 0.5) / double(n);
      const glm::dvec3 d = map_direction(map, position);
      const double solid_angle = std::numbers::pi / 3 * std::numbers::pi / 3 / (n * n) *
                                 std::sin(position.y / 3 * std::numbers::pi);
      const ShVector<double> y = sh_basis(6, d);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += solid_angle * y[k];
    }
    const ShVector<glm::dvec3> sh = map_sh(map, 6);
    for (std::size_t k = 0; k < sum.size(); ++k) EXPECT_NEAR(sh[k].y, sum[k], 1e-4) << k;
  }
}

TEST(Environment, RotatesWithItsMap) {
  constexpr int width = 12;
  constexpr int height = 6;
  const RadianceMap map = random_map(10, width, height);
  // About +y by +90 degrees: what stood at -z (the middle) comes to -x (a quarter to the left).
  RadianceMap turned{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) turned.pixels.push_back(map.pixel((x + 3) % width, y));
  }
  Environment environment;
  environment.map = std::make_shared<const RadianceMap>(map);
  environment.rotation = 90.0;
  environment.intensity = 2.0;
  const ShVector<glm::dvec3> a = environment_sh(environment, 6);
  const ShVector<glm::dvec3> b = map_sh(turned, 6);
  for (std::size_t i = 0; i < a.size(); ++i) expect_near(a[i], 2.0 * b[i], 1e-12);
  Random random(11);
  for (int n = 0; n < 100; ++n) {
    const glm::dvec3 d = glm::normalize(random.point(1.0));
    expect_near(environment_radiance(environment, d), 2.0 * map_radiance(turned, d), 1e-12);
  }
}

TEST(Environment, LookUpAndProjectionAgree) {
  // A smooth map that six bands hold well.
  RadianceMap map{256, 128, {}};
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const glm::dvec3 d = map_direction(map, {x + 0.5, y + 0.5});
      map.pixels.emplace_back(glm::dvec3(2 + d.x, 1 + d.y * d.y, 1 - d.z * d.x));
    }
  }
  Environment environment;
  environment.map = std::make_shared<const RadianceMap>(std::move(map));
  environment.rotation = 30.0;
  const ShVector<glm::dvec3> sh = environment_sh(environment, 6);
  for (const SphereNode& node : sphere_rule(10)) {
    // Pixels are 1/40 wide, and bilinear and constant pixels differ by its square.
    expect_near(sh_evaluate(sh, node.direction), environment_radiance(environment, node.direction),
                1e-3);
  }
}

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

// Data made of the map stay as long as nothing changes.
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
