// Orthographic cameras, as every method sees through them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/scene/camera_rays.h"
#include "core/scene/cameras.h"
#include "render/layers/surface_layers.h"
#include "render/reference/reference_pixels.h"
#include "render/renderer.h"
#include "render/samples/brightness.h"
#include "render/samples/exposure.h"
#include "tests/render/regions.h"
#include "tests/render/test_scenes.h"
#include "tests/render/traced_truth.h"

namespace brume {
namespace {

// Seen slanted, with the plane of the eye before all that is in the scene.
Scene seen_in_parallel(Scene scene) {
  scene.film = {40, 32};
  scene.camera.eye = {1.5, 2.0, 4.0};
  scene.camera.target = {0.1, 0.0, 0.0};
  scene.camera.height = 2.6;
  return scene;
}

// The same from `distance` away by a pinhole.
Scene seen_from_afar(Scene scene, double distance) {
  Camera& camera = scene.camera;
  camera.eye = camera.target + distance * glm::normalize(camera.eye - camera.target);
  camera = perspective(camera);
  return scene;
}

Scene with_ray_noise(Scene scene) {
  scene.optics.noise = {.amplitude = 0.4, .frequency = 2.0};
  return scene;
}

// It has no edges in the picture.
Scene before_a_wide_wall(Scene scene) {
  scene.surfaces.push_back(wall(-0.4, 9.0));
  return scene;
}

Scene under_an_even_sky(Scene scene, double anisotropy) {
  scene.environment = even_sky(0.3f);
  scene.optics.anisotropy = anisotropy;
  return scene;
}

struct ParallelCase {
  const char* name;
  Scene scene;
};

std::vector<ParallelCase> parallel_cases() {
  return {{"cloud", cloud_scene(30, 2.0)},
          {"ellipsoids", ellipsoid_scene(24, 2.0, 8.0)},
          {"noise", with_ray_noise(cloud_scene(30, 2.0))},
          {"noise in ellipsoids", with_ray_noise(ellipsoid_scene(24, 2.0, 8.0))},
          {"wall", before_a_wide_wall(cloud_scene(30, 2.0))},
          {"forward under a sky", under_an_even_sky(before_a_wide_wall(cloud_scene(30, 2.0)), 0.7)},
          {"backward under a sky", under_an_even_sky(cloud_scene(30, 2.0), -0.4)}};
}

// From 300 u the directions to the picture's edges differ by 0.4%, and so much do sizes, by which
// pixels see what is 0.01 u beside.
constexpr double distance_of_afar = 300.0;
constexpr double difference_of_afar = 0.012;

void expect_limit_of_pinholes(const Settings& settings, const char* method,
                              double bound = difference_of_afar) {
  for (const auto& [name, scene] : parallel_cases()) {
    SCOPED_TRACE(testing::Message() << method << ", " << name);
    const Scene parallel = seen_in_parallel(scene);
    const Frame frame = render_frame(parallel, settings);
    const Frame limit = render_frame(seen_from_afar(parallel, distance_of_afar), settings);
    expect_finite(frame);
    EXPECT_LT(rel_rmse(frame.airlight, limit.airlight), bound);
    EXPECT_LT(rel_rmse(frame.transmittance, limit.transmittance), bound);
    EXPECT_LT(rel_rmse(frame.beauty, limit.beauty), bound);
  }
}

TEST(Orthographic, IsTheLimitOfPinholesSliced) {
  expect_limit_of_pinholes(sliced(24), "sliced");
}

TEST(Orthographic, IsTheLimitOfPinholesForAllOrders) {
  Settings settings = all_orders(24, {.nodes = 2000, .directions = 32});
  expect_limit_of_pinholes(settings, "all orders");
}

TEST(Orthographic, IsTheLimitOfPinholesByThePaper) {
  expect_limit_of_pinholes(paper_settings, "paper");
  Settings improved = paper_settings;
  improved.paper = {true, true};
  expect_limit_of_pinholes(improved, "improved paper");
}

TEST(Orthographic, PaperInSimdIsThePlainFrame) {
  for (const auto& [name, scene] : parallel_cases()) {
    SCOPED_TRACE(name);
    Settings settings = paper_settings;
    settings.paper = {true, true};
    settings.depth_error = 1e-7;  // culling is not the same in both
    const Scene parallel = seen_in_parallel(in_fog(scene, 0.02));
    const Frame fast = render_frame(parallel, settings);
    settings.precision = Settings::Precision::plain_double;
    const Frame plain = render_frame(parallel, settings);
    EXPECT_LT(rel_rmse(fast.airlight, plain.airlight), 1e-3);
  }
}

// In fog, where the plane of the eye matters; bounds as of pinholes.
TEST(Orthographic, SlicedIsTheReferenceInFog) {
  for (const auto& [name, scene] :
       {ParallelCase{"cloud", cloud_scene(30, 2.0)},
        ParallelCase{"wall", before_a_wide_wall(cloud_scene(30, 2.0))},
        ParallelCase{"noise", with_ray_noise(before_a_wide_wall(cloud_scene(30, 2.0)))},
        ParallelCase{"ellipsoids", before_a_wide_wall(ellipsoid_scene(24, 2.0, 8.0))}}) {
    SCOPED_TRACE(name);
    const Scene parallel = seen_in_parallel(in_fog(scene, 0.05));
    const Frame reference = render_frame(parallel, reference_settings(1e-5));
    EXPECT_LT(rel_rmse(render_frame(parallel, sliced(48)).airlight, reference.airlight), 0.006);
  }
}

// A wall 5 u before the plane of the eye, which looks along -z; 2.6 u high and 3.25 u wide are
// seen.
Scene before_a_wall_along_z() {
  Scene scene =
      seen_by({.eye = {0.3, -0.2, 4.0}, .target = {0.3, -0.2, 0.0}, .height = 2.6}, {40, 32});
  scene.surfaces.push_back(wall(-1.0, 9.0));
  return scene;
}

// Where its rays start, by what a scene file's `height` means and without CameraRays.
glm::dvec3 start_of(std::size_t pixel) {
  const double x = static_cast<double>(pixel % 40) + 0.5;
  const double y = static_cast<double>(pixel / 40) + 0.5;
  return {0.3 + 3.25 * (x / 40.0 - 0.5), -0.2 + 2.6 * (0.5 - y / 32.0), 4.0};
}

// Fog and a Gaussian through which the plane of the eye cuts.
TEST(Orthographic, TransmittanceIsTheClosedForm) {
  Scene scene = in_fog(before_a_wall_along_z(), 0.05);
  const Gaussian g{{0.1, 0.2, 3.8}, 0.5, 1.3};
  scene.medium.append(g);
  for (Settings settings : {reference_settings(1e-5), sliced(24), paper_settings}) {
    SCOPED_TRACE(static_cast<int>(settings.airlight));
    settings.depth_error = 1e-6;
    const Frame frame = render_frame(scene, settings);
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      ASSERT_NEAR(frame.depth[i], 5.0, 1e-5);
      const glm::dvec3 q = (g.center - start_of(i)) / g.radius;
      const double through = 0.5 * std::sqrt(std::numbers::pi) * g.density * g.radius *
                             std::exp(-q.x * q.x - q.y * q.y) *
                             (std::erf(5.0 / g.radius + q.z) - std::erf(q.z));
      ASSERT_NEAR(frame.transmittance[3 * i], std::exp(-through - 5.0 * 0.05), 1e-5);
    }
  }
}

// Midpoints of 2000 steps are exact to 1e-6: the light is 1.5 u above the picture.
TEST(Orthographic, AirlightOfFogIsTheIntegral) {
  constexpr double b0 = 0.2;
  Scene scene = in_fog(before_a_wall_along_z(), b0);
  const glm::dvec3 light(0.8, 2.6, 1.0);
  scene.lights.push_back({light, {9.0, 9.0, 9.0}, {}});
  const Frame reference = render_frame(scene, reference_settings(1e-6));
  const Frame frame = render_frame(scene, sliced(48));
  constexpr int steps = 2000;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) {
      const double t = 5.0 * (k + 0.5) / steps;
      const double d = glm::distance(light, start_of(i) - glm::dvec3(0.0, 0.0, t));
      sum += b0 * std::exp(-b0 * (t + d)) / (d * d);
    }
    const double airlight = 9.0 * sum * 5.0 / steps / (4.0 * std::numbers::pi);
    ASSERT_NEAR(reference.airlight[3 * i], airlight, 1e-5 * airlight);
    ASSERT_NEAR(frame.airlight[3 * i], airlight, 2e-3 * airlight);
  }
}

// A wall moves while the camera does, and the camera sees more of it.
TEST(Orthographic, LayersHavePlacesAndMotion) {
  const Scene scene = before_a_wall_along_z();
  Scene next = scene;
  next.surfaces[0].translate = {0.1, 0.0, 0.3};
  next.camera.eye.y += 0.2;
  next.camera.target.y += 0.2;
  next.camera.height = 3.0;
  ImageLayers image;
  add_surface_layers(scene, scene.camera, scene.film, {.position = true, .motion = true}, &next,
                     next.camera, {}, image);
  for (std::size_t i = 0; i < 40 * 32; ++i) {
    const glm::dvec3 start = start_of(i);
    ASSERT_NEAR(image.channels.at("position.X")[i], start.x, 1e-6);
    ASSERT_NEAR(image.channels.at("position.Y")[i], start.y, 1e-6);
    ASSERT_NEAR(image.channels.at("position.Z")[i], -1.0, 1e-6);
    const double x = 32.0 / 3.0 * (start.x + 0.1 - 0.3);
    const double y = 32.0 / 3.0 * start.y;
    ASSERT_NEAR(image.channels.at("forward.u")[i], x - 32.0 / 2.6 * (start.x - 0.3), 1e-5);
    ASSERT_NEAR(image.channels.at("forward.v")[i], y - 32.0 / 2.6 * (start.y + 0.2), 1e-5);
  }
}

// The plane of the eye in the middle of all: nothing behind it is seen.
TEST(Orthographic, SeesFromThePlaneOfTheEyeOn) {
  Scene scene = seen_in_parallel(in_fog(before_a_wide_wall(cloud_scene(30, 2.0)), 0.05));
  scene.camera.eye = scene.camera.target + 0.05 * (scene.camera.eye - scene.camera.target);
  const Frame reference = render_frame(scene, reference_settings(1e-5));
  const Frame frame = render_frame(scene, sliced(48));
  EXPECT_LT(rel_rmse(frame.airlight, reference.airlight), 0.006);
  for (std::size_t i = 0; i < frame.transmittance.size(); ++i) {
    ASSERT_NEAR(frame.transmittance[i], reference.transmittance[i], 2e-3);
  }
}

TEST(Orthographic, AllOrdersMatchPaths) {
  Scene scene =
      on_film(seen_in_parallel(in_fog(before_a_wide_wall(cloud_scene(24, 2.5)), 0.05)), {15, 12});
  expect_all_orders_match_paths(scene, "in parallel");
}

TEST(Orthographic, ReferencePixelsAreThoseOfTheFrame) {
  const Scene scene = seen_in_parallel(in_fog(before_a_wide_wall(cloud_scene(10, 2.0)), 0.05));
  const Frame frame = render_frame(scene, reference_settings(1e-5));
  const ReferencePixels reference(scene, scene.camera, scene.film, 1e-5);
  const std::array<std::size_t, 3> pixels{85, 640, 1101};
  const std::vector<glm::dvec3> airlight = reference.airlight(pixels, {}, {});
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    EXPECT_NEAR(airlight[k].y, frame.airlight[3 * pixels[k] + 1], 1e-4 * airlight[k].y);
  }
}

// Distances are along the axis, all rays see one direction of the sky, and sizes do not fall with
// distance.
TEST(Orthographic, HasNoPerspective) {
  Scene scene = seen_in_parallel(Scene());
  scene.camera.eye = {0, 0, 5};
  scene.camera.target = {};
  scene.camera.height = 4.0;
  scene.film = {40, 40};
  scene.surfaces = {wall(1.0, 1.0), wall(-3.0, 1.0)};
  scene.surfaces[1].translate.x = 2.0;
  const Frame frame = render_frame(scene, sliced(24));
  std::array<int, 2> count{};
  for (const float depth : frame.depth) {
    if (!std::isfinite(depth)) continue;
    const bool is_far = depth > 6.0f;
    ++count[is_far ? 1 : 0];
    EXPECT_NEAR(depth, is_far ? 8.0 : 4.0, 1e-5);
  }
  EXPECT_EQ(count[0], 400);
  EXPECT_EQ(count[1], 200);  // half of it is in the picture
}

TEST(Orthographic, RegionsHaveTheBitsOfTheWhole) {
  Scene scene =
      on_film(seen_in_parallel(in_fog(before_a_wide_wall(cloud_scene(30, 2.0)), 0.02)), {150, 110});
  for (const int samples : {1, 4}) {
    Settings settings = sliced(12);
    settings.airlight_scale = 4;
    settings.samples = samples;
    Renderer renderer;
    settings = *with_brightness(renderer, scene, scene.camera, scene.film, settings, {});
    const Frame whole = render_frame(scene, settings);
    Scene part = scene;
    part.film = film_region(scene.film, {0.3, 0.2}, {0.7, 0.8});
    expect_same_pixels(whole, render_frame(part, settings));
  }
}

// Interpolated airlight and several samples a pixel.
TEST(Orthographic, SampledAndUpsampledFramesAreNear) {
  Scene scene =
      on_film(seen_in_parallel(in_fog(before_a_wide_wall(cloud_scene(30, 2.0)), 0.02)), {96, 80});
  const Frame exact = render_frame(scene, sliced(24));
  Settings settings = sliced(24);
  settings.airlight_scale = 4;
  EXPECT_LT(rel_rmse(render_frame(scene, settings).airlight, exact.airlight), 0.01);
  settings.samples = 16;
  const Frame sampled = render_frame(scene, settings);
  EXPECT_LT(rel_rmse(sampled.airlight, exact.airlight), 0.02);
}

TEST(Orthographic, ShuttersBlurWithoutALens) {
  const Scene scene = seen_in_parallel(cloud_scene(3, 2.0));
  const LensView view = seen_through(scene.camera, scene.film, {0.5, -0.3});
  EXPECT_EQ(view.camera, scene.camera);
  EXPECT_EQ(view.film, scene.film);
}

}  // namespace
}  // namespace brume
