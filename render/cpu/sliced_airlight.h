#pragma once

#include "render/cpu/light_table.h"
#include "render/cpu/ray_slices.h"
#include "render/cpu/shadow_map.h"
#include "render/cpu/tile_rays.h"
#include "render/environment_source.h"

namespace brume {

// The sliced airlight for the pixels of one tile: every ray is cut into slices, the optical depth
// of each is exact, light is attenuated by the table of its light, and the mean of 1/r^2 over a
// slice is exact. Light of an environment comes from a grid. Light that changes within a slice is
// what the error is made of.

struct SlicedLight {
  glm::dvec3 position{0.0};
  glm::dvec3 intensity{0.0};           // RGB [W/sr]
  double h_min = 0.0;                  // see light_limits.h [u]
  const LightTable* table = nullptr;   // of this position; null without Gaussians
  const ShadowMap* shadows = nullptr;  // of this position; null without surfaces
};

// Overwrites `out`. `gaussians`: the medium's that reach the tile; `environment`: null if there is
// none; `slices`: those of the tile. Returns the number of Gaussian x ray pairs evaluated.
// Thread-safe.
std::uint64_t sliced_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                              std::span<const SlicedLight> lights,
                              const EnvironmentSource* environment, const TileRays& rays,
                              const SliceNodes& slices, const TileAirlight& out);

}  // namespace brume
