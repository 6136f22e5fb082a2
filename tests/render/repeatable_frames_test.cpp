// A frame is a function of scene, camera and settings.

#include "tests/render/repeatable_frames.h"

#include <gtest/gtest.h>

#include <array>
#include <stop_token>

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

TEST(RepeatableFrames, Paper) {
  expect_repeatable(create_cpu_renderer, paper_settings);
}

TEST(RepeatableFrames, March) {
  Settings settings;
  settings.airlight = AirlightMethod::march;
  settings.march_steps = 16;
  expect_repeatable(create_cpu_renderer, settings);
}

TEST(RepeatableFrames, Paths) {
  Settings settings;
  settings.airlight = AirlightMethod::path;
  settings.paths = 2;
  expect_repeatable(create_cpu_renderer, settings);
}

}  // namespace
}  // namespace brume
