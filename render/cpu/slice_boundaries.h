#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/cpu/sliced_airlight.h"
#include "render/cpu/tile_rays.h"
#include "render/medium_index.h"

namespace brume {

// A Gaussian alone begins and ends where bins of slice demand do: so far into the next bin it still
// counts as that, or rounding would decide.
constexpr double bin_room = 1e-3;

// What is seen of a Gaussian this deep is its tail.
constexpr double slice_opaque = 40.0;

// Where the slices of a tile's rays begin and end, ascending [u]: about `slices` of them where its
// Gaussians are, finer where these are small and dense, and as many again for fog and for lights in
// or near the medium. All rays of a tile share them; they are chosen on its middle ray. Fewer than
// two: there is no medium on the rays.
void choose_slices(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                   std::span<const SlicedLight> lights, const TileRays& rays, int slices,
                   std::vector<double>& boundaries);

}  // namespace brume
