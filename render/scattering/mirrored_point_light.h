#pragma once

#include <glm/vec3.hpp>

#include "render/grid/grid_occlusion.h"
#include "render/grid/ordinates.h"
#include "render/scattering/node_point_light.h"
#include "render/util/job.h"

namespace brume {

// Adds the unscattered light of `light` that mirror planes of the surfaces send to `incident`, at
// nodes of which the first lies at `first`: as from the light's mirror images, times Fresnel's term
// (Schlick), where both the plane and, from there, the light are seen. Rougher highlights count as
// mirrors, too; Gaussians between plane and node do not attenuate it.
void add_mirrored_point_light(const NodePointLight& light, const GridOcclusion& surfaces,
                              const glm::dvec3& first, const GridNodes& nodes, NodeLight& incident,
                              const Job& job);

}  // namespace brume
