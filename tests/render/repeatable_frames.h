#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "brume/scene.h"
#include "render/frame_renderer.h"
#include "render/settings.h"

namespace brume {

// Five frames in which the camera, a light, Gaussians and a surface move, with an environment, fog
// and shadows.
std::vector<Scene> moving_scenes();
// Five frames of 40,000 Gaussians, an emitter and a sequence, evaluated at their times: enough of
// them to be merged.
std::vector<Scene> crowded_scenes();

// Renders scenes forwards, backwards, in pieces by separate renderers and on one thread, and
// expects every layer of every frame to be the same to the last bit.
void expect_repeatable(const std::function<std::unique_ptr<FrameRenderer>()>& create_renderer,
                       Settings settings, const std::vector<Scene>& scenes = moving_scenes());

}  // namespace brume
