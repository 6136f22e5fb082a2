#include "render/prepare/light_pixels.h"
#include "core/scene/camera_rays.h"
#include "render/prepare/sample_spacing.h"
#include "render/renderer.h"
#include "tools/bench/scenes/benchmark_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace brume {
namespace {

constexpr Film small_film{8, 6};

// Looks along -z from 1 u away at the plane z = 0, where a pixel is 1 u wide.
Camera camera() {
  Camera camera;
  camera.eye = {0.0, 0.0, 1.0};
  camera.vertical_fov = 2.0 * std::atan(3.0) * 180.0 / std::numbers::pi;
  return camera;
}

// A light that is seen at a film position.
Light light_at(double x, double y) {
  Light light;
  light.position = {x - 4.0, 3.0 - y, 0.0};
  return light;
}

std::vector<glm::ivec2> pixels_of(const std::vector<Light>& lights, int width) {
  Scene scene;
  scene.lights = lights;
  return light_pixels(point_lights(scene), CameraRays(camera(), small_film), small_film, width);
}

using Pixels = std::vector<glm::ivec2>;

TEST(LightPixels, OneIsThePixelOfTheLight) {
  EXPECT_EQ(pixels_of({light_at(2.3, 4.9)}, 1), Pixels({{2, 4}}));
}

TEST(LightPixels, BlockHoldsTheNearestCentres) {
  EXPECT_EQ(pixels_of({light_at(2.3, 4.9)}, 2), Pixels({{1, 4}, {2, 4}, {1, 5}, {2, 5}}));
  EXPECT_EQ(pixels_of({light_at(2.7, 4.1)}, 2), Pixels({{2, 3}, {3, 3}, {2, 4}, {3, 4}}));
  EXPECT_EQ(pixels_of({light_at(4.4, 3.4)}, 4).size(), 16U);
}

TEST(LightPixels, AreClippedToTheFilm) {
  EXPECT_EQ(pixels_of({light_at(-0.3, 2.5)}, 1), Pixels());
  EXPECT_EQ(pixels_of({light_at(-0.3, 2.5)}, 3), Pixels({{0, 1}, {0, 2}, {0, 3}}));
  EXPECT_EQ(pixels_of({light_at(8.9, 6.9)}, 3), Pixels({{7, 5}}));
}

TEST(LightPixels, EachPixelIsListedOnce) {
  EXPECT_EQ(pixels_of({light_at(3.5, 2.5), light_at(2.5, 2.5), light_at(3.4, 2.4)}, 1),
            Pixels({{2, 2}, {3, 2}}));
}

TEST(LightPixels, LightsThatAreNotSeenHaveNone) {
  Light off = light_at(3.5, 2.5);
  off.on = false;
  Light black = light_at(3.5, 2.5);
  black.intensity = glm::dvec3(0.0);
  Light behind;
  behind.position = {0.0, 0.0, 2.0};
  Light eye;
  eye.position = camera().eye;
  Light beside;
  beside.position = camera().eye + glm::dvec3(1e300, 0.0, -1e-10);
  EXPECT_EQ(pixels_of({off, black, behind, eye, beside}, 4), Pixels());
}

// In front of the box_of() so many Gaussians, 1 wide, which fills most of the film's height.
Scene box_in_view(int count) {
  Scene scene;
  scene.medium = box_of(count);
  scene.camera = {{0.5, 0.5, 2.5}, {0.5, 0.5, 0.5}, {0, 1, 0}, 40.0};
  scene.film = {800, 600};
  return scene;
}

int spacing(const Scene& scene, int wanted) {
  return with_useful_spacing(scene, scene.camera, scene.film, {.airlight_scale = wanted})
      .airlight_scale;
}

TEST(SampleSpacing, IsOnePixelWhereGaussiansAreSmaller) {
  EXPECT_EQ(spacing(box_in_view(100'000), 4), 1);  // 2 pixels
  EXPECT_EQ(spacing(box_in_view(100'000), 2), 2);
  EXPECT_EQ(spacing(box_in_view(10'000), 4), 4);  // 6 pixels
}

TEST(SampleSpacing, FollowsTheFilmAndTheDistance) {
  Scene scene = box_in_view(100'000);
  scene.film = {3200, 2400};
  EXPECT_EQ(spacing(scene, 4), 4);
  scene.film = {800, 600};
  scene.camera.eye.z = 0.8;  // before what is left of the box
  EXPECT_EQ(spacing(scene, 4), 4);
  scene.camera.eye.z = 12.5;
  scene.film = {3200, 2400};
  EXPECT_EQ(spacing(scene, 4), 1);
}

TEST(SampleSpacing, StaysWhereGaussiansAreFew) {
  const Scene scene = box_in_view(9'999);
  EXPECT_EQ(with_useful_spacing(scene, scene.camera, {8, 6}, {.airlight_scale = 4}).airlight_scale,
            4);
}

// Visible Gaussians decide, not the most frequent ones.
TEST(SampleSpacing, WeighsGaussiansByWhatIsSeenOfThem) {
  Scene scene = box_in_view(100'000);
  for (const double x : {0.2, 0.5, 0.8}) {
    for (int i = 0; i < 300; ++i) {
      scene.medium.append({{x, 0.5, 0.01 * (i % 100)}, 0.2, 1.0, {}, {}, {}});
    }
  }
  EXPECT_EQ(spacing(scene, 4), 4);
}

TEST(SampleSpacing, FramesOfTinyGaussiansAreExact) {
  Scene scene = box_in_view(20'000);
  scene.lights.push_back({{1.5, 3.0, 2.0}, {10, 10, 10}, {}});
  scene.film = {64, 48};
  const auto airlight = [&](int scale) {
    Settings settings = sliced_settings({}, 8);
    settings.airlight_scale = scale;
    return Renderer().render(scene, scene.camera, scene.film, settings)->airlight;
  };
  EXPECT_EQ(airlight(4), airlight(1));
}

}  // namespace

}  // namespace brume
