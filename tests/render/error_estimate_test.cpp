#include "render/error_estimate.h"

#include <gtest/gtest.h>

#include "render/auto_quality.h"
#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Settings method(AirlightMethod airlight, int slices = 16) {
  Settings settings;
  settings.airlight = airlight;
  settings.slices = slices;
  return settings;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  all.push_back(cloud_scene(30, 1.0));
  all.push_back(cloud_scene(300, 3.0));
  all.push_back(cloud_scene(100, 1.0));
  all.back().lights[0].position = {0.4, 0.3, 0.2};  // inside
  all.push_back(cloud_scene(50, 0.5));
  all.back().medium.set_homogeneous_density(0.05);
  all.push_back(cloud_scene(50, 2.0));
  all.back().surfaces.push_back(wall(0.0, 0.6));
  return all;
}

// The interval holds the error of the whole frame in at least 95% of cases.
TEST(ErrorEstimate, IntervalHoldsTheTruth) {
  int held = 0;
  int cases = 0;
  int narrow = 0;
  for (Scene& scene : scenes()) {
    scene.film = {40, 40};
    const Frame truth = render_frame(scene, method(AirlightMethod::reference));
    for (const Settings& settings :
         {method(AirlightMethod::paper), method(AirlightMethod::sliced, 8),
          method(AirlightMethod::sliced, 16)}) {
      const Frame frame = render_frame(scene, settings);
      const double error = difference(frame.airlight, truth.airlight).relative_rmse;
      for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const auto sample = ErrorSample::take(scene, scene.camera, frame, 150, seed, 1e-4);
        const ErrorEstimate estimate = sample->measure(frame);
        EXPECT_LE(estimate.pixels, 150u);
        held += estimate.low <= error && error <= estimate.high ? 1 : 0;
        ++cases;
        narrow += estimate.high < 3.0 * estimate.low ? 1 : 0;
      }
    }
  }
  EXPECT_GE(held, 0.95 * cases) << held << " of " << cases;
  // And it says something.
  EXPECT_GE(narrow, 0.9 * cases) << narrow << " of " << cases;
}

TEST(ErrorEstimate, OfTheReferenceItselfIsNothing) {
  Scene scene = cloud_scene(30, 1.0);
  scene.film = {20, 20};
  const Frame truth = render_frame(scene, method(AirlightMethod::reference));
  const auto sample = ErrorSample::take(scene, scene.camera, truth, 60, 1, 1e-4);
  EXPECT_LT(sample->measure(truth).high, 1e-6);
}

TEST(AutoQuality, KeepsTheErrorAskedFor) {
  for (Scene& scene : scenes()) {
    scene.film = {60, 60};
    const Frame truth = render_frame(scene, method(AirlightMethod::reference));
    Renderer renderer;
    for (const double asked : {0.05, 0.01}) {
      const auto settings =
          choose_settings(renderer, scene, scene.camera, scene.film, Settings{}, asked);
      const Frame frame = render_frame(scene, *settings);
      EXPECT_LT(difference(frame.airlight, truth.airlight).relative_rmse, asked);
    }
  }
}

TEST(AutoQuality, SpendsLessWhereLessIsAskedFor) {
  const Scene scene = cloud_scene(300, 3.0);
  Renderer renderer;
  const auto loose = choose_settings(renderer, scene, scene.camera, scene.film, {}, 0.1);
  const auto tight = choose_settings(renderer, scene, scene.camera, scene.film, {}, 0.003);
  EXPECT_LT(loose->slices, tight->slices);
}

}  // namespace
}  // namespace brume
