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

// How many boundaries a ray may have: more lights than that leaves room for get fewer slices each.
constexpr std::size_t max_slice_boundaries = 1024;

// How many slices each light in or near the medium gets, of `lights` that shine.
int slices_per_light(int slices, std::size_t lights);

// As many boundaries as choose_slices() may find.
std::size_t max_boundaries(int slices, std::size_t lights, bool in_fog);

// Where the slices of a tile's rays begin and end, ascending [u]: about `slices` of them where its
// Gaussians are, finer where these are small and dense, and as many again for fog and for lights in
// or near the medium. They are chosen on the rays' center. Fewer than two: there is no medium on
// the rays.
void choose_slices(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                   std::span<const SlicedLight> lights, const TileCone& rays, int slices,
                   std::vector<double>& boundaries);

}  // namespace brume
