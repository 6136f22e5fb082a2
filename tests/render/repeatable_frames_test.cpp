// A frame is a function of scene, camera and settings.

#include "tests/render/repeatable_frames.h"

#include <gtest/gtest.h>

#include <array>
#include <stop_token>

#include "core/medium/medium_edit.h"
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

TEST(RepeatableFrames, Paper) {
  expect_repeatable(create_cpu_renderer, paper_settings);
}

TEST(RepeatableFrames, March) {
  Settings settings;
  settings.airlight = AirlightMethod::march;
  settings.march_steps = 16;
  expect_repeatable(create_cpu_renderer, settings);
}

// A frame of an edit that was stopped before its tables were asked for.
TEST(RepeatableFrames, AStoppedEditLeavesNoPendingPatch) {
  Scene scene = cloud_scene(300, 2.0);
  scene.film = {31, 23};
  scene.environment.emplace().map = constant_sky(0.3f);
  const Settings rest = sliced_settings({}, 12);
  Settings motion = rest;
  motion.patch_light_tables = true;
  Renderer renderer;
  static_cast<void>(renderer.render(scene, scene.camera, scene.film, rest));
  const std::array ids{scene.medium.ids()[10]};
  Gaussian moved = scene.medium.gaussian(10);
  moved.center *= 0.9;
  moved.density *= 3.0;
  MediumEdit::change(scene.medium, ids, std::array{moved}).apply(scene.medium);
  std::stop_source stopped;
  stopped.request_stop();
  ASSERT_FALSE(renderer.render(scene, scene.camera, scene.film, motion, stopped.get_token()));
  const Frame frame = *renderer.render(scene, scene.camera, scene.film, rest);
  EXPECT_EQ(frame.airlight, render_frame(scene, rest).airlight);
  EXPECT_EQ(frame.beauty, render_frame(scene, rest).beauty);
}

}  // namespace
}  // namespace brume
