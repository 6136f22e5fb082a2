#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/scene/camera.h"
#include "render/environment_light.h"
#include "render/frame.h"
#include "render/job.h"

namespace brume {

// What is behind the medium at a pixel of a film of `width`: what `surfaces` send (RGB per pixel;
// empty: nothing), or where nothing is hit the environment (null: there is none).
glm::vec3 behind_medium(const CameraRays& rays, const EnvironmentLight* environment,
                        std::span<const glm::vec3> surfaces, const Frame& frame, std::size_t pixel);

// Eq. 29: frame.beauty of the frame's other layers and what is behind the medium.
void composite(const CameraRays& rays, const EnvironmentLight* environment,
               std::span<const glm::vec3> surfaces, const Job& job, Frame& frame);

}  // namespace brume
