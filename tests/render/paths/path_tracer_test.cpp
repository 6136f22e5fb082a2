// Paths against what is known exactly, or converged: light scattered once, furnaces, reciprocity.

#include "render/paths/path_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "core/scene/lights/radiance_map.h"
#include "render/paths/direction_sampling.h"
#include "render/prepare/fog_extent.h"
#include "render/reference/surface_reference.h"
#include "tests/render/paths/traced_scene.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

const glm::dvec3 origin(0.2, 0.1, 4.0);

// Within four standard errors, which are small enough to tell.
void expect_matches(const PathEstimate& got, const glm::dvec3& expected, double relative_error) {
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(got.mean[c], expected[c], 4.0 * got.error[c] + 1e-6 * expected[c]);
    EXPECT_LT(got.error[c], relative_error * expected[c]);
  }
}

Environment upward_sky() {
  auto sky = std::make_shared<RadianceMap>(RadianceMap{64, 32, {}});
  for (int i = 0; i < 64 * 32; ++i) {
    const glm::dvec3 d = map_direction(*sky, {i % 64 + 0.5, i / 64 + 0.5});
    sky->pixels.emplace_back(glm::dvec3(1.0 + 0.8 * d.y, 1.0, 1.0 + 0.5 * d.x));
  }
  Environment environment;
  environment.map = sky;
  return environment;
}

void expect_single_scattering(const Scene& scene, double relative_error) {
  const TracedScene traced(scene);
  for (const glm::dvec3& target : {glm::dvec3(0, 0, 0), glm::dvec3(0.5, -0.3, 0.2)}) {
    expect_matches(traced.airlight(origin, target, 16'000).orders[0],
                   traced.single_scattering(origin, target), relative_error);
  }
}

TEST(PathTracer, FirstOrderMatchesTheReferenceInAClump) {
  expect_single_scattering(cloud_scene(20, 3.0), 0.01);
}

TEST(PathTracer, FirstOrderMatchesTheReferenceInFog) {
  Scene scene = in_fog(cloud_scene(20, 1.0), 0.1);
  scene.lights.push_back({{0.4, -0.2, 1.0}, {1.0, 2.0, 3.0}, {}});
  expect_single_scattering(scene, 0.01);
  // One of many lights is chosen at random.
  for (int i = 0; i < 6; ++i) {
    scene.lights.push_back({{0.5 * i - 1.5, 2.0 - i % 3, 0.4 * i}, glm::dvec3(1.0 + i), {}});
  }
  expect_single_scattering(scene, 0.02);
}

TEST(PathTracer, FirstOrderMatchesTheReferenceWhenScatteringIsAnisotropic) {
  for (const double g : {-0.5, 0.8}) {
    Scene scene = cloud_scene(20, 2.0);
    scene.optics.anisotropy = g;
    expect_single_scattering(scene, 0.01);
  }
}

TEST(PathTracer, FirstOrderMatchesTheReferenceUnderASky) {
  Scene scene = cloud_scene(20, 3.0);
  scene.lights.clear();
  scene.environment = upward_sky();
  scene.medium.set_homogeneous_density(0.05);
  scene.optics.anisotropy = 0.4;
  expect_single_scattering(scene, 0.01);
}

TEST(PathTracer, FirstOrderMatchesTheReferenceInShadow) {
  Scene scene = in_fog(cloud_scene(20, 2.0), 0.05);
  scene.lights = {{{1.5, 0.2, -3.0}, glm::dvec3(10.0), {}}};
  scene.surfaces = {wall(-1.5, 0.4)};
  expect_single_scattering(scene, 0.01);
}

TEST(PathFog, EndsAroundTheScene) {
  Medium fog;
  fog.set_homogeneous_density(0.5);
  const MediumIndex index(fog, 1e-9);
  const std::vector<PointSource> lights{{{{1, 0, 0}, glm::dvec3(1.0)}},
                                        {{{-1, 0, 0}, glm::dvec3(1.0)}}};
  const glm::dvec3 w = glm::normalize(glm::dvec3(1, 2, 3));
  const FogBall ball{glm::dvec3(0.0), 4.0};
  const PathFog limited = PathFog::around(index, RayCaster({}), lights, {0, 0, 3}, ball);
  EXPECT_NEAR(limited.length({0, 0, 0}, w), 4.0, 1e-12);
  EXPECT_NEAR(limited.length(3.0 * w, w), 1.0, 1e-12);
  EXPECT_NEAR(limited.length(3.0 * w, -w), 7.0, 1e-12);
  EXPECT_EQ(limited.length(8.0 * w, w), 0.0);
  EXPECT_EQ(limited.importance(100.0 * w), 1.0);

  const PathFog endless = PathFog::around(index, RayCaster({}), lights, {0, 0, 3}, FogBall());
  const double out = endless.length({0, 0, 0}, w);
  EXPECT_NEAR(out, 3.0 + 2.0 + PathFog::max_free_paths * 2.0, 1e-9);
  EXPECT_NEAR(endless.length(3.0 * w, w), out - 3.0, 1e-9);
  EXPECT_EQ(endless.importance(4.0 * w), 1.0);
  EXPECT_NEAR(endless.importance(20.0 * w), 0.25, 1e-12);

  const MediumIndex clear(Medium{}, 1e-9);
  EXPECT_EQ(PathFog::around(clear, RayCaster({}), lights, {0, 0, 3}, ball).length(w, w), 0.0);
}

// Under a constant sky nothing can be told from it, however the fog scatters.
TEST(PathTracer, AFurnaceIsConstant) {
  for (const double b0 : {0.0, 0.3}) {
    for (const double g : {0.0, 0.7}) {
      Scene scene = cloud_scene(20, 4.0);
      scene.lights.clear();
      scene.environment = even_sky(2.0f);
      scene.medium.set_homogeneous_density(b0);
      scene.optics.anisotropy = g;
      const MediumIndex index(scene.medium, 1e-9);
      const TracedScene traced(scene);
      const TracedScene::Estimate got = traced.airlight(origin, {0, 0, 0}, 4000);
      const double opacity = -std::expm1(
          -CameraRay(index, origin, glm::normalize(-origin), FogExtent(scene).ray_distance(origin))
               .depth());
      expect_matches(got.sum, glm::dvec3(2.0 * opacity), 0.02);
    }
  }
}

// So does a white surface in it.
TEST(PathTracer, AWhiteSurfaceInAFurnaceIsConstant) {
  Scene scene = cloud_scene(20, 3.0);
  scene.lights.clear();
  scene.environment = even_sky(1.0f);
  scene.medium.set_homogeneous_density(0.1);
  scene.surfaces = {wall(-0.3, 0.8, 1.0)};
  scene.surfaces.push_back(ball_surface(24, 0.4, {0.3, 0.2, 0.4}));
  scene.surfaces.back().material.reflectance = glm::dvec3(1.0);
  const TracedScene traced(scene);
  // A ball of flat triangles is not quite closed to interpolated normals.
  for (const glm::dvec3& target : {glm::dvec3(-0.4, -0.4, -0.3), glm::dvec3(0.3, 0.2, 0.4)}) {
    const TracedScene::Estimate got = traced.surface(origin, target, 4000);
    EXPECT_NEAR(got.sum.mean.x, 1.0, 4.0 * got.sum.error.x + 2e-3);
    EXPECT_LT(got.sum.error.x, 0.02);
  }
}

// Light of an isotropic light at a, gathered from all directions at b, is the same the other way.
TEST(PathTracer, LightAndEyeCanBeExchanged) {
  Scene scene = in_fog(cloud_scene(12, 3.0, 3), 0.05);
  scene.optics.anisotropy = 0.5;
  const glm::dvec3 a(0.2, 0.1, 1.4);
  const glm::dvec3 b(-0.9, 0.8, -0.3);
  const auto gathered = [&](const glm::dvec3& light, const glm::dvec3& receiver) {
    scene.lights = {{light, glm::dvec3(1.0), {}}};
    const TracedScene traced(scene, 0.95);
    constexpr int directions = 4000;
    double sum = 0.0;
    double square = 0.0;
    for (int i = 0; i < directions; ++i) {
      PathRandom random(3, 0, static_cast<std::uint64_t>(i), 0);
      // Half around the light, where most comes from.
      const glm::dvec3 axis = glm::normalize(light - receiver);
      const double turn = std::numbers::pi * random.uniform();
      const glm::dvec3 w = random.uniform() < 0.5
                               ? direction_around(axis, std::cos(turn), random)
                               : direction_around(axis, 2.0 * random.uniform() - 1.0, random);
      const double sine = glm::length(glm::cross(axis, w));
      const double pdf =
          0.5 / (4.0 * std::numbers::pi) + 0.5 / (2.0 * std::numbers::pi * std::numbers::pi * sine);
      const double radiance =
          traced.airlight(receiver, receiver + w, 2 * path_block, static_cast<std::uint64_t>(i))
              .sum.mean.x /
          pdf;
      sum += radiance / directions;
      square += radiance * radiance / directions;
    }
    return PathEstimate{glm::dvec3(sum),
                        glm::dvec3(std::sqrt((square - sum * sum) / (directions - 1)))};
  };
  const PathEstimate there = gathered(a, b);
  const PathEstimate back = gathered(b, a);
  EXPECT_NEAR(there.mean.x, back.mean.x, 4.0 * std::hypot(there.error.x, back.error.x));
  EXPECT_LT(there.error.x, 0.04 * there.mean.x);
}

// A surface reflects direct light, and light that was scattered once before.
void expect_reflected_light(const Scene& scene, double relative_error, int paths = 40'000) {
  const TracedScene traced(scene);
  const glm::dvec3 target(0.2, -0.1, -0.5);
  const glm::dvec3 w = glm::normalize(target - origin);
  const SurfaceHit hit = traced.ray_caster().first_hit(origin, w);
  ASSERT_TRUE(hit);
  const SurfacePoint point = traced.ray_caster().point(hit, origin, w, scene.surfaces);
  const ReflectedLight expected = reflected_light(scene, traced.ray_caster(), point,
                                                  {.samples = static_cast<std::size_t>(2 * paths)});
  const TracedScene::Estimate got = traced.surface(origin, target, paths);
  for (int c = 0; c < 3; ++c) {
    const double direct = std::hypot(got.orders[0].error[c], expected.error[c]);
    const double scattered = std::hypot(got.orders[1].error[c], expected.error[c]);
    EXPECT_NEAR(got.orders[0].mean[c], expected.attenuated[c], 4.0 * direct);
    EXPECT_NEAR(got.orders[1].mean[c], expected.scattered[c], 4.0 * scattered);
    EXPECT_LT(scattered, relative_error * expected.scattered[c]);
  }
}

TEST(PathTracer, SurfacesReflectDirectAndScatteredLight) {
  Scene scene = cloud_scene(20, 1.0);
  scene.surfaces = {wall(-0.5, 2.0)};
  expect_reflected_light(scene, 0.03);
  scene.surfaces[0].material.type = Material::Type::phong;
  scene.surfaces[0].material.specular = {0.1, 0.3, 0.5};
  scene.surfaces[0].material.exponent = 20.0;
  scene.medium.set_homogeneous_density(0.1);
  expect_reflected_light(scene, 0.03);
}

// A mirror shows the light that is scattered along one segment of a walk: in fog, collisions and
// equi-angular samples share it, these the rarer the farther the light is.
TEST(PathTracer, SegmentsOfWalksMatchTheReferenceCloseToLights) {
  Scene scene;
  scene.surfaces = {wall(-0.5, 2.0)};
  Material& material = scene.surfaces[0].material;
  material.type = Material::Type::phong;
  material.reflectance = glm::dvec3(0.0);
  material.specular = glm::dvec3(1.0);
  material.exponent = 1e8;
  scene.optics.anisotropy = 0.3;
  const glm::dvec3 target(0.2, -0.1, -0.5);
  for (const double b0 : {0.3, 2.0}) {
    scene.medium = Medium();
    scene.medium.set_homogeneous_density(b0);
    if (b0 < 1.0) scene.medium.append({{0.4, 0.0, 0.8}, 0.5, 3.0});
    for (const double x : {0.25, 0.7, 1.2}) {
      scene.lights = {{{x, 0.1, 0.4}, glm::dvec3(3.0), {}}};
      // Absorbing: further orders, not looked at here, end soon.
      const TracedScene traced(scene, 0.1);
      const glm::dvec3 w = glm::normalize(target - origin);
      const glm::dvec3 mirrored(w.x, w.y, -w.z);
      const glm::dvec3 expected =
          mirrored.z * traced.single_scattering(target + 1e-4 * mirrored, target + mirrored);
      const PathEstimate got = traced.surface(origin, target, 16'000).orders[1];
      // The lobe is a ten thousandth wide.
      EXPECT_NEAR(got.mean.x, expected.x, 4.0 * got.error.x + 1e-3 * expected.x);
      EXPECT_LT(got.error.x, 0.01 * expected.x);
    }
  }
}

TEST(PathTracer, SurfacesReflectASky) {
  Scene scene = cloud_scene(20, 1.0);
  scene.lights.clear();
  scene.environment = upward_sky();
  scene.surfaces = {wall(-0.5, 2.0)};
  expect_reflected_light(scene, 0.03, 30'000);
}

}  // namespace
}  // namespace brume
