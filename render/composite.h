#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/scene/camera.h"
#include "render/environment_light.h"
#include "render/frame.h"
#include "render/job.h"

namespace brume {

// Sets what is behind the medium in row y of a frame: what `surfaces` send (RGB per pixel of the
// frame; empty: nothing), or where nothing is hit the environment (null: there is none).
void behind_medium(const CameraRays& rays, const EnvironmentLight* environment,
                   std::span<const glm::vec3> surfaces, const Frame& frame, std::size_t y,
                   std::span<glm::vec3> behind);

// Eq. 29: frame.beauty of the frame's other layers and what is behind the medium.
void composite(const CameraRays& rays, const EnvironmentLight* environment,
               std::span<const glm::vec3> surfaces, const Job& job, Frame& frame);

}  // namespace brume
