#pragma once

#include "render/geometry/medium_index.h"
#include "render/geometry/point_source.h"
#include "render/geometry/tile_rays.h"
#include "render/scattering/source_function.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Ray-marched airlight for the pixels of one tile, for comparison with the other methods: midpoint
// rule with steps of equal length over the ray's part inside the medium. Optical depths towards eye
// and lights are exact, with a shadow ray per sample. Only environment light is approximated, as in
// the sliced airlight.

// Overwrites `out`. `gaussians`: indices of those that may contribute; `environment`: may be null;
// `steps` >= 1 per ray. Returns the Gaussian x ray pairs evaluated, including those towards lights.
// Thread-safe.
std::uint64_t marched_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                               const RayCaster& ray_caster, std::span<const PointSource> lights,
                               const SourceFunction* environment, const TileRays& rays, int steps,
                               const TileAirlight& out);

}  // namespace brume
