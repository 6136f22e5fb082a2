#pragma once

#include <span>
#include <vector>

#include "render/cpu/tile_rays.h"
#include "render/medium_index.h"
#include "render/settings.h"

namespace brume {

// The paper's airlight (section 3) for the pixels of one tile.

struct PaperLight {
  glm::dvec3 position{0.0};
  glm::dvec3 intensity{0.0};   // RGB [W/sr]
  double h_min = 0.0;          // see light_limits.h [u]
  double depth_to_eye = 0.0;   // of the Gaussians, T(s, v) without b0
  std::vector<double> frozen;  // per Gaussian: Tbar_i(s, b_i) + Tbar_i(v, b_i), b0 included
};

// Overwrites `out`. `gaussians`: the medium's that reach the tile. Returns the number of
// Gaussian x ray pairs evaluated. Thread-safe.
std::uint64_t paper_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                             std::span<const PaperLight> lights, const TileRays& rays,
                             Settings::Arithmetic arithmetic, const TileAirlight& out);

}  // namespace brume
