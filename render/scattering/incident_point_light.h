#pragma once

#include <glm/vec3.hpp>

#include "render/grid/ordinates.h"
#include "render/scattering/node_point_light.h"
#include "render/util/job.h"

namespace brume {

// Adds the unscattered light of `light`, I falloff exp(-T) / r^2, to `incident`, at nodes of which
// the first lies at `first`; at edges of the falloff its mean over the cells around a node. Nodes
// near the light, or in a beam that is narrow between nodes, get the mean of all of that over what
// they see of their cells: see LightRays. `occlusion`: of the nodes; null: there are no surfaces.
void add_point_light(const NodePointLight& light, const glm::dvec3& first, const GridNodes& nodes,
                     const GridOcclusion* occlusion, NodeLight& incident, const Job& job);

// Adds what the surfaces between the nodes reflect of it, per channel and surfel; see
// reflected_light(). A surfel stands for what falls on a square, one spacing wide.
void add_reflected_point_light(const NodePointLight& light, const GridOcclusion& surfaces,
                               const glm::dvec3& first, const GridNodes& nodes,
                               std::span<float> reflected, std::size_t channels, const Job& job);

}  // namespace brume
