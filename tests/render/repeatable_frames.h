#pragma once

#include <functional>
#include <memory>

#include "render/frame_renderer.h"
#include "render/settings.h"

namespace brume {

// Renders an animation (camera, a light, Gaussians and a surface move; an environment, fog,
// shadows) forwards, backwards, in pieces by separate renderers and on one thread, and expects
// every layer of every frame to be the same to the last bit.
void expect_repeatable(const std::function<std::unique_ptr<FrameRenderer>()>& create_renderer,
                       Settings settings);

}  // namespace brume
