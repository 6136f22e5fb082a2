#pragma once

#include "core/scene/lights/point_lights.h"
#include "render/simd/area_kernels.h"
#include "render/simd/surface_points.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// radiance += the highlight of an area light, of which `light` is a point, on what is so smooth
// that its points would show: of rays over the lobe, alike at all points, those that meet the
// light. What the points have of the highlight, and these rays, add up to one by the balance
// heuristic (Veach 1997): see add_ggx_light(). `of_points`: the sum of the light's points.
// Thread-safe.
void add_area_highlight(const SurfacePoints& points, const RayCaster& ray_caster,
                        const PointLight& light, const AreaSum& of_points, PointRadiance& radiance);

}  // namespace brume
