#pragma once

#include "render/geometry/tile_rays.h"
#include "render/lighting/optical_depth_table.h"
#include "render/lighting/ray_slices.h"
#include "render/lighting/shadow_map.h"
#include "render/lighting/sliced_light.h"
#include "render/lighting/source_function.h"
#include "render/lighting/source_lookup.h"

namespace brume {

// A point light of the sliced airlight. Rays are cut into slices with exact optical depths; light
// is attenuated by its table, and the mean of 1/r^2 over a slice is exact. Environment light comes
// from a grid. The error is due to light that varies within a slice.

// Light that a grid holds, see SourceFunction, and how an eye looks it up.
struct SlicedSource {
  const SourceFunction* function;
  SourceLookup lookup;
};

// Sliced airlight of one tile. Overwrites `out`. `gaussians`: indices of those that may contribute;
// `source`: from the rays' eye, may be null; `slices`: of the tile. Returns the Gaussian x ray
// pairs evaluated. Thread-safe.
std::uint64_t sliced_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                              std::span<const SlicedLight> lights, const SlicedSource* source,
                              const TileRays& rays, const SliceNodes& slices,
                              const TileAirlight& out);

}  // namespace brume
