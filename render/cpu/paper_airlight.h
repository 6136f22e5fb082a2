#pragma once

#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "render/medium_index.h"
#include "render/settings.h"
#include "render/tiles.h"

namespace brume {

// The paper's airlight (section 3) for the pixels of one tile.

struct PaperLight {
  glm::dvec3 position{0.0};
  glm::dvec3 intensity{0.0};   // RGB [W/sr]
  double h_min = 0.0;          // see light_limits.h [u]
  double depth_to_eye = 0.0;   // of the Gaussians, T(s, v) without b0
  std::vector<double> frozen;  // per Gaussian: Tbar_i(s, b_i) + Tbar_i(v, b_i), b0 included
};

struct TileRays {
  glm::dvec3 eye{0.0};
  std::span<const glm::dvec3> directions;  // unit
  std::span<const double> lengths;         // to the surface [u], or +inf
};

struct TileAirlight {
  std::span<glm::vec3> airlight;  // RGB radiance
  std::span<double> depths;       // T(v, p), b0 included; +inf possible
};

// Overwrites `out`. `gaussians`: the medium's that reach the tile. Returns the number of
// Gaussian x ray pairs evaluated. Thread-safe.
std::uint64_t paper_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                             std::span<const PaperLight> lights, const TileRays& rays,
                             Settings::Arithmetic arithmetic, const TileAirlight& out);

}  // namespace brume
