#pragma once

#include <vector>

#include "brume/frame.h"
#include "brume/scene.h"
#include "render/frame_renderer.h"
#include "render/settings.h"

namespace brume {

// The picture of the scene's camera, by a renderer that has rendered nothing before, or by this
// one.
Frame render_frame(const Scene& scene, const Settings& settings);
Frame render_frame(FrameRenderer& renderer, const Scene& scene, const Settings& settings);

// The root-mean-square difference of two layers over b's rms; infinite where one of the two is not
// a number.
double rel_rmse(const std::vector<float>& a, const std::vector<float>& b);

}  // namespace brume
