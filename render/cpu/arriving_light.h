#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/math/spherical_harmonics.h"
#include "render/cpu/sweep_kernels.h"
#include "render/job.h"

namespace brume {

// So many bands of spherical harmonics a grid keeps of light.
inline constexpr int grid_bands = 4;

// What fog around the Gaussians, and the medium's optics, do to light that arrives at surfaces.
struct ArrivalOptics {
  double fog_density = 0.0;  // b0 [1/u]
  // Band by band, how much of the light that the Gaussians let pass arrives through the fog,
  // straight and scattered in it.
  std::array<double, grid_bands> through_fog{1.0, 1.0, 1.0, 1.0};
  // How much of what the Gaussians scatter arrives: albedo and fog.
  double scattered = 1.0;
  double anisotropy = 0.0;  // g

  bool operator==(const ArrivalOptics&) const = default;
};

// The light of an environment that arrives at the nodes of a grid, straight and scattered once by
// the medium on its way, as coefficients of four bands: node by node, for each R G B 0. No surface
// stands in its way.
//
// `straight` has what the Gaussians let pass as rows of `stride` elements, R G B of one coefficient
// after the other. What they scatter is swept through the grid for even directions; no point spread
// function is assumed. After a stop of the job the result is of no use.
std::vector<float> arriving_light(const GridNodes& nodes, std::span<const float> density,
                                  std::span<const float> straight, std::size_t stride,
                                  const ArrivalOptics& optics, const Job& job);

}  // namespace brume
