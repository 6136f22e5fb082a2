#pragma once

#include "render/cpu/tile_rays.h"
#include "render/cpu/visibility.h"
#include "render/environment_source.h"
#include "render/medium_index.h"

namespace brume {

// The marched airlight for the pixels of one tile: what a careful ray marcher computes, to measure
// the other methods against. Each ray takes the midpoint rule on steps of equal length over the
// part of it that lies in the medium; at each sample the optical depths towards the eye and
// towards every light are exact, and a shadow ray asks for surfaces. No table, no approximation
// but the rule itself; only the light of an environment, which comes from all around, is that of
// the sliced airlight.

struct MarchedLight {
  glm::dvec3 position{0.0};
  glm::dvec3 intensity{0.0};  // RGB [W/sr]
  double h_min = 0.0;         // see light_limits.h [u]
};

// Overwrites `out`. `gaussians`: the medium's that reach the tile; `environment`: null if
// there is none; `steps` >= 1 per ray. Returns the number of Gaussian x ray pairs evaluated, those
// towards the lights included. Thread-safe.
std::uint64_t marched_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                               const Visibility& visibility, std::span<const MarchedLight> lights,
                               const EnvironmentSource* environment, const TileRays& rays,
                               int steps, const TileAirlight& out);

}  // namespace brume
