#pragma once

#include "app/view/drawing/overlay.h"
#include "core/scene/camera_rays.h"

namespace brume {

// Draws a camera as seen by another: its eye, and what of the film's plane through its target it
// sees.
void add_camera_outline(Overlay& overlay, const CameraRays& rays, const Camera& camera,
                        const Film& film);

}  // namespace brume
