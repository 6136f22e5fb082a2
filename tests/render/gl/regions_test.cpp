// A region of a film has the bits of the whole picture on the device, too.

#include "tests/render/regions.h"

#include "tests/render/gl/gl_frames.h"

namespace brume::gl {
namespace {

class GlRegions : public GlFrames {};

TEST_F(GlRegions, HaveTheBitsOfTheWholePicture) {
  Settings settings = quick_slices();
  settings.samples = 2;
  expect_region_matches(*gl_, 2, {{72, 40}, settings});
  settings.samples = 1;
  settings.airlight_scale = 2;
  expect_region_matches(*gl_, 3, {{200, 60}, settings});
  settings.airlight_scale = 4;
  settings.airlight = AirlightMethod::paper;
  expect_region_matches(*gl_, 5, {{340, 60}, settings});
}

}  // namespace
}  // namespace brume::gl
