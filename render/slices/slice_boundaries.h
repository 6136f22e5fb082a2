#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/geometry/medium_index.h"
#include "render/geometry/tile_rays.h"
#include "render/slices/sliced_light.h"

namespace brume {

// Tolerance of bins of slice demand: an isolated Gaussian begins and ends at bin borders, where
// rounding would decide.
constexpr double bin_room = 1e-3;

// Beyond this optical depth only the tail of a Gaussian is visible.
constexpr double slice_opaque = 40.0;

// Where slices are demanded; also by the shaders.
namespace slice_demand {
// Bins per slice.
constexpr int bins_per_slice = 4;
// A Gaussian is a box of this half width in radii, with its integral: of this share of its peak.
constexpr double box_radii = 1.5;
constexpr double box_share = 0.59;
// Tails of opaque Gaussians are boxes, each wider by this [radii], out to where the tail has this
// optical depth; others need slices out to core_radii.
constexpr double tail_step = 0.5;
constexpr double tail_depth = 0.02;
constexpr double core_radii = 2.0;
// Optical depth in front attenuates the demand, up to this.
constexpr double max_front_depth = 4.0;
// Where a tile's rays meet more Gaussians than this, a sample demands slices, and those whose
// depth is this many times the mean.
constexpr std::size_t max_gaussians = 256;
constexpr double outstanding = 4.0;
// The uniform share, relative to the mean of what is demanded.
constexpr double uniform_share = 0.3;
}  // namespace slice_demand

// One in so many of the points that stand for an area light, or for all that emits, demands slices.
constexpr int points_per_demand = 4;

// Slices of equal angle at a light: for lights nearer to the range than this fraction of its
// length.
constexpr double near_light_share = 0.5;
// A light almost on the ray stands off it by this share of a slice, of the range or, if the medium
// is endless, of this many of the light's distances.
constexpr double light_slice_share = 0.25;
constexpr double light_distances = 16.0;

// Boundaries merge that are closer than this fraction of the range or of their distance: closer
// boundaries are equal in float.
constexpr double min_gap_of_range = 1e-9;
constexpr double min_gap_of_distance = 1e-6;

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
