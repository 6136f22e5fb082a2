#pragma once

#include <filesystem>
#include <functional>

#include "brume/scene.h"
#include "core/io/gaussians/splat_output.h"

namespace brume {

// Bakes the light of a scene's fog into splats (render/splats), exposed by so many stops and shown
// as a .png is, and returns what writes them: a PLY of splats, or a web page if the extension is
// .html. Throws Interrupted.
std::function<void()> lit_splats(const Scene& scene, double exposure, OpacityAlong along,
                                 bool y_down, const std::filesystem::path& output);

}  // namespace brume
