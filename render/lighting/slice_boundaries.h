#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/geometry/medium_index.h"
#include "render/geometry/tile_rays.h"
#include "render/lighting/sliced_light.h"

namespace brume {

// Tolerance of bins of slice demand: an isolated Gaussian begins and ends at bin borders, where
// rounding would decide.
constexpr double bin_room = 1e-3;

// Beyond this optical depth only the tail of a Gaussian is visible.
constexpr double slice_opaque = 40.0;

// Maximum number of boundaries per ray; with more lights than fit, each gets fewer slices.
constexpr std::size_t max_slice_boundaries = 1024;

// Extra slices for each light in or near the medium, with `lights` lights on.
int slices_per_light(int slices, std::size_t lights);

// Upper bound of the boundaries that choose_slices() returns.
std::size_t max_boundaries(int slices, std::size_t lights, bool in_fog);

// Chooses slice boundaries for the rays of a tile, ascending [u]: about `slices` over the range of
// its Gaussians, denser where these are small and dense, and as many again for fog and for lights
// in or near the medium. Chosen on the central ray. Fewer than two: no medium.
void choose_slices(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                   std::span<const SlicedLight> lights, const TileCone& rays, int slices,
                   std::vector<double>& boundaries);

}  // namespace brume
