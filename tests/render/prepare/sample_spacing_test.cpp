#include "render/prepare/sample_spacing.h"

#include <gtest/gtest.h>

#include "render/renderer.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

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
