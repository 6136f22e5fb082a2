#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "render/geometry/point_source.h"
#include "render/lighting/optical_depth_table.h"
#include "render/lighting/ordinates.h"
#include "render/util/job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// A point light and what attenuates it on its way to the nodes of a grid.
struct NodePointLight {
  const PointSource& source;
  std::array<float, 3> intensity{};          // per channel of the nodes [W/sr]
  const OpticalDepthTable* table = nullptr;  // null: no Gaussians
  double extinction = 1.0;                   // factor of the table's optical depths
  double fog = 0.0;                          // homogeneous extinction [1/u]
  const RayCaster* surfaces = nullptr;       // that occlude it; null: none
  // Of a light that is normally distributed around its position, along each axis [u]; 0: a point.
  double deviation = 0.0;
};

// Adds its unscattered light I exp(-T) / r^2, or the mean of 1 / r^2, to `incident`, at nodes of
// which the first lies at `first`; times its falloff, of which all nodes get the mean. Nodes near
// the light get the mean over what they see of the cells around them, weighted by its share of a
// trilinear interpolation: so the integral of 1 / r^2 is kept. `occlusion`: of the nodes; null:
// there are no surfaces.
void add_point_light(const NodePointLight& light, const glm::dvec3& first, const GridNodes& nodes,
                     const GridOcclusion* occlusion, NodeLight& incident, const Job& job);

// Adds what the surfaces between the nodes reflect of it, per channel and surfel; see
// reflected_light(). Within half a spacing the light counts as that far away: nearer, one surfel
// would stand for a bright spot.
void add_reflected_point_light(const NodePointLight& light, const GridOcclusion& surfaces,
                               const glm::dvec3& first, const GridNodes& nodes,
                               std::span<float> reflected, std::size_t channels, const Job& job);

}  // namespace brume
