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
  glm::dvec3 intensity{0.0};     // RGB [W/sr]
  double h_min = 0.0;            // see light_limits.h [u]
  double depth_to_eye = 0.0;     // of the Gaussians, T(s, v) without b0
  std::vector<double> frozen;    // per Gaussian: Tbar_i(s, b_i) + Tbar_i(v, b_i), b0 included
  bool conserve_energy = false;  // see PaperOptions
};

// All lights of a frame, and what its eye sees of every Gaussian.
struct PaperLights {
  std::vector<PaperLight> lights;
  std::vector<double> from_eye;  // per Gaussian: Tbar_i(v, b_i) without b0
  bool at_mean = false;          // see PaperOptions
};

// Whether a point lies in or at a Gaussian so dense that what it scatters varies much within: there
// one point per Gaussian is far from its mean, and scaling by energy makes it worse.
bool is_in_dense_gaussian(const MediumIndex& medium, const glm::dvec3& point);

// Overwrites `out`. `gaussians`: the medium's that reach the tile. Returns the number of
// Gaussian x ray pairs evaluated. Thread-safe.
std::uint64_t paper_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                             const PaperLights& paper, const TileRays& rays,
                             Settings::Arithmetic arithmetic, const TileAirlight& out);

}  // namespace brume
