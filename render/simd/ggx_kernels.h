#pragma once

#include <glm/vec3.hpp>

#include "render/simd/surface_points.h"

namespace brume {

// radiance += direct light that metallic-roughness materials reflect where lit, times e^-T
// (Highway, single precision); SurfacePoints::ggx has what they are at each point. `intensity`: of
// the light [W/sr]; `is_seen`: mirrored rays meet it, so that highlights are theirs where
// GgxPoints::lobe is 0. Scalar double counterpart: ggx_brdf().
void add_ggx_light(const SurfacePoints& points, const LightAtPoints& light,
                   const glm::vec3& intensity, bool is_seen, PointRadiance& radiance);

}  // namespace brume
