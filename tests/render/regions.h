#pragma once

#include "brume/camera.h"
#include "brume/frame.h"
#include "render/frame_renderer.h"
#include "tests/random.h"

namespace brume {

struct RegionRequest {
  Film film;
  Settings settings;
};

// Whether a random region of a random scene has all bits of the whole film's.
void expect_region_matches(FrameRenderer& renderer, unsigned seed, const RegionRequest& request);

// Whether `part` has all bits that these pixels have in `whole`.
void expect_same_pixels(const Frame& whole, const Frame& part);

}  // namespace brume
