#pragma once

#include <span>

#include "render/geometry/medium_index.h"
#include "render/geometry/tile_rays.h"
#include "render/lights/paper_lights.h"
#include "render/settings.h"

namespace brume {

// A point light with the depths that the paper's airlight (section 3) needs.

// Overwrites `out`. `gaussians`: indices of those that may contribute. Returns the Gaussian x ray
// pairs evaluated. Thread-safe.
std::uint64_t paper_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                             const PaperLights& paper, const TileRays& rays,
                             Settings::Precision precision, const TileAirlight& out);

}  // namespace brume
