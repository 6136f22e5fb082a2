#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/math/infinity.h"
#include "core/medium/gaussian_term.h"
#include "render/lights/emission_lights.h"

namespace brume {

// Where a SourceGrid has its finest nodes: low > high if nowhere.
struct MediumBounds {
  glm::dvec3 low{infinity};
  glm::dvec3 high{-infinity};
  double min_radius = infinity;  // of the Gaussians there

  [[nodiscard]] bool empty() const { return !(low.x <= high.x); }
};

// The bounds of substantial_gaussians(), which all of the emission lights (null: none) are; 1% of
// their extinction is beyond, where look-ups clamp to the border.
MediumBounds medium_bounds(std::span<const GaussianTerm<double>> gaussians,
                           const EmissionLights* emission);

}  // namespace brume
