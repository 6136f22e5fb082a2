#pragma once

#include "core/scene/lights/point_lights.h"
#include "render/simd/surface_points.h"

namespace brume {

// radiance += direct light that metallic-roughness materials reflect where lit, times e^-T
// (Highway, single precision); SurfacePoints::ggx has what they are at each point. Of lights
// that are seen, mirrored rays hold the highlights where GgxPoints::lobe is 0, of points of area
// lights the part of highlight_rays is left out. Scalar double counterpart: ggx_brdf().
void add_ggx_light(const SurfacePoints& points, const PointLight& source,
                   const LightAtPoints& light, PointRadiance& radiance);

}  // namespace brume
