#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "brume/frame.h"
#include "core/scene/camera_rays.h"
#include "render/scattering/environment_light.h"
#include "render/util/job.h"

namespace brume {

// Background of row y, before attenuation by the medium: surface radiance (`surfaces`, RGB per
// pixel; empty: black), or the environment where nothing is hit (null: none).
void behind_medium(const CameraRays& rays, const EnvironmentLight* environment,
                   std::span<const glm::vec3> surfaces, const Frame& frame, std::size_t y,
                   std::span<glm::vec3> behind);

// Eq. 29: composites frame.beauty from the other layers and the background.
void composite(const CameraRays& rays, const EnvironmentLight* environment,
               std::span<const glm::vec3> surfaces, const Job& job, Frame& frame);

// The pixels that are held out show what is in front of them alone, and their alpha is that of it.
void hold_out(const std::function<bool(std::size_t pixel)>& is_held_out, const Job& job,
              Frame& frame);

// Frame::background of a frame whose pixels are one ray each: all that open ones show behind the
// medium.
void set_background_apart(Frame& frame);

}  // namespace brume
