#pragma once

#include <glm/vec3.hpp>

#include "brume/gaussian.h"
#include "core/scene/camera_rays.h"

namespace brume {

class SurfacePicker;
struct Overlay;

// The cursor of a brush that lays this Gaussian: its outlines at 1/e and at 1% of its density,
// dashed where a surface is before them, and faintly a plane through its center.
void add_brush_cursor(Overlay& overlay, const CameraRays& rays, SurfacePicker& surfaces,
                      const Gaussian& laid, const glm::dvec3& normal);

// A ghost of the Gaussian, as opaque as it is before surfaces. `color`: linear RGB.
void add_ghost(Overlay& overlay, const CameraRays& rays, SurfacePicker& surfaces,
               const Gaussian& laid, const glm::dvec3& color);

}  // namespace brume
