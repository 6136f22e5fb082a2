// A frame of the device, too, is a function of scene, camera and settings.

#include "tests/render/repeatable_frames.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/render/gl/gl_frames.h"

namespace brume::gl {
namespace {

TEST(GlRepeatableFrames, SlicedInterpolated) {
  Settings settings = quick_slices();
  settings.airlight_scale = 4;
  expect_repeatable(
      [] {
        std::string problem;
        std::unique_ptr<FrameRenderer> renderer = GlRenderer::create(nullptr, problem);
        EXPECT_TRUE(renderer) << problem;
        return renderer;
      },
      settings);
}

}  // namespace
}  // namespace brume::gl
