// A frame is a function of scene, camera and settings.

#include "tests/render/repeatable_frames.h"

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <vector>

#include "brume/edits.h"
#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

std::unique_ptr<FrameRenderer> create_cpu_renderer() {
  return std::make_unique<Renderer>();
}

TEST(RepeatableFrames, SlicedInterpolated) {
  Settings settings = sliced_settings({}, 12);
  settings.airlight_scale = 4;
  expect_repeatable(create_cpu_renderer, settings);
}

TEST(RepeatableFrames, SlicedEveryPixel) {
  expect_repeatable(create_cpu_renderer, sliced_settings({}, 16));
}

TEST(RepeatableFrames, Merged) {
  const std::vector<Scene> scenes = crowded_scenes();
  const Settings settings = sliced_settings({}, 8);
  ASSERT_GT(render_frame(scenes[0], settings).statistics.gaussians_merged, 0u);
  expect_repeatable(create_cpu_renderer, settings, scenes);
}

TEST(RepeatableFrames, Paper) {
  expect_repeatable(create_cpu_renderer, paper_settings);
}

TEST(RepeatableFrames, Paths) {
  Settings settings;
  settings.airlight = AirlightMethod::path;
  settings.paths = 2;
  expect_repeatable(create_cpu_renderer, settings);
}

// On a farm frames come from processors with other vector instructions: they differ by rounding.
TEST(RepeatableFrames, AcrossVectorInstructions) {
  const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  ASSERT_FALSE(targets.empty());
  Settings solved = all_orders(16, {.nodes = 2000, .directions = 32});
  for (Scene scene : {cloud_scene(30, 2.0), in_fog(cut_by_a_surface(), 0.05)}) {
    scene.film = {16, 12};
    for (const Settings& settings : {sliced(16), solved, paper_settings}) {
      std::vector<Frame> frames;
      for (const std::int64_t target : targets) {
        hwy::SetSupportedTargetsForTest(target);
        frames.push_back(render_frame(scene, settings));
      }
      hwy::SetSupportedTargetsForTest(0);
      for (std::size_t k = 1; k < frames.size(); ++k) {
        SCOPED_TRACE(airlight_name(settings) + ", " + hwy::TargetName(targets[k]));
        // The iteration for all orders is accelerated by what sweeps change, whose rounding grows.
        const double bound = settings.scattering == Scattering::multiple ? 1e-4 : 1e-5;
        EXPECT_LT(rel_rmse(frames[k].beauty, frames[0].beauty), bound);
        EXPECT_LT(rel_rmse(frames[k].airlight, frames[0].airlight), bound);
      }
    }
  }
}

}  // namespace
}  // namespace brume
