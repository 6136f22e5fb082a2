#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "render/geometry/tile_rays.h"
#include "render/optical_depth/optical_depth_table.h"
#include "render/optical_depth/ray_slices.h"
#include "render/scattering/source_function.h"
#include "render/scattering/source_lookup.h"
#include "render/shading/mirrored_light.h"
#include "render/slices/shadow_map.h"
#include "render/slices/sliced_light.h"

namespace brume {

// A point light of the sliced airlight. Rays are cut into slices with exact optical depths; light
// is attenuated by its table, and the mean of 1/r^2 over a slice is exact. Environment light comes
// from a grid. The error is due to light that varies within a slice.

// Light that a grid holds, see SourceFunction, and how an eye looks it up.
struct SlicedSource {
  const SourceFunction* function;
  SourceLookup lookup;
  const EyeLobe* lobe = nullptr;  // of this eye; null: unknown
};

// Airlight and optical depth of the rays of a tile up to each of `count` distances, ascending on
// every ray: [k * rays + i]. Optical depths are also known half-way between: [(2 k) * rays + i],
// and
// [(2 k + 1) * rays + i] up to the middle.
struct TileProfiles {
  std::size_t parts = 1;         // in: slices are cut into 2 * parts of equal length
  std::size_t count = 0;         // 0: no medium in the tile
  std::vector<float> distances;  // [u], as often as depths
  std::vector<double> depths;    // b0 included
  std::vector<glm::vec3> airlight;
};

// Sliced airlight of one tile. Overwrites `out`. `gaussians`: indices of those that may contribute;
// `source`: from the rays' eye, may be null; `slices`: of the tile. Returns the Gaussian x ray
// pairs evaluated. `profiles`: filled if not null; out.airlight is what they end with. Thread-safe.
std::uint64_t sliced_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                              std::span<const SlicedLight> lights, const SlicedSource* source,
                              const TileRays& rays, const SliceNodes& slices,
                              const TileAirlight& out, TileProfiles* profiles = nullptr);

// The same of rays from points beside each other, at offsets from their eye, which are none of a
// film: with slices of their own, about half of `slices`. Those that meet Gaussians are evaluated
// one by one: only parallel rays share what is prepared of these. `source`: may be null.
// Thread-safe.
void sliced_airlight_along(const MediumIndex& medium, std::span<const SlicedLight> lights,
                           const SourceFunction* source, int slices, TileRays rays,
                           const TileAirlight& out);

// The same as a function of the rays, of light that scatters with this albedo. Refers to all but
// the lights.
AirlightAlong sliced_airlight_along(const MediumIndex& medium,
                                    std::shared_ptr<const std::vector<SlicedLight>> lights,
                                    const SourceFunction* source, int slices, double albedo);

}  // namespace brume
