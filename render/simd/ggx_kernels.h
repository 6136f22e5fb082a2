#pragma once

#include <glm/vec3.hpp>

#include "render/simd/surface_points.h"

namespace brume {

// radiance += direct light that metallic-roughness materials reflect where lit, times e^-T
// (Highway, single precision); SurfacePoints::ggx has what they are at each point. `intensity`: of
// the light [W/sr]. Scalar double counterpart: ggx_brdf().
void add_ggx_light(const SurfacePoints& points, const LightAtPoints& light,
                   const glm::vec3& intensity, PointRadiance& radiance);

}  // namespace brume
