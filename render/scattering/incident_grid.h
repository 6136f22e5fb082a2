#pragma once

#include <array>
#include <vector>

#include "render/grid/ordinates.h"
#include "render/util/job.h"

namespace brume {

// Effect of homogeneous fog and the medium's optics on light incident at surfaces.
struct IncidentOptics {
  double fog_density = 0.0;  // b0 [1/u]
  // Per band, the fraction of the light transmitted by the Gaussians that passes the fog, direct
  // and scattered.
  std::array<double, grid_bands> through_fog{1.0, 1.0, 1.0, 1.0};
  // Fraction of the light scattered by the Gaussians that arrives: albedo times fog transmittance.
  double scattered = 1.0;
  double anisotropy = 0.0;  // g

  bool operator==(const IncidentOptics&) const = default;
};

// Environment light incident at the nodes of a grid, unscattered and scattered once, as
// coefficients of four bands: per node and basis function R G B 0. Surfaces do not occlude it.
//
// `unscattered` holds the light transmitted by the Gaussians, of three channels. Scattered light is
// swept through the grid for uniformly distributed directions; no point spread function is assumed.
// Invalid after the job was stopped.
std::vector<float> incident_light(const GridNodes& nodes, std::span<const float> density,
                                  const NodeLight& unscattered, const IncidentOptics& optics,
                                  const Job& job);

}  // namespace brume
