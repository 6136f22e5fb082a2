#pragma once

#include <span>
#include <vector>

#include "brume/scene.h"
#include "core/scene/camera_rays.h"
#include "render/geometry/point_source.h"
#include "render/prepare/fog_extent.h"

namespace brume {

// The lights of a view as methods evaluate them. `lights` are point lights already, as of
// RenderPlan::lights.
std::vector<PointSource> point_sources(std::span<const PointLight> lights, const CameraRays& rays,
                                       const Camera& camera, const FogExtent& extent);

}  // namespace brume
