#pragma once

#include <glm/vec3.hpp>

#include "brume/medium.h"

namespace brume {

// Statistics of a medium; zero without Gaussians.
struct MediumSummary {
  glm::dvec3 min_center{0.0};  // bounds of the centers [u]
  glm::dvec3 max_center{0.0};
  glm::dvec3 min_extent{0.0};  // bounds of center -+ 2 radius, where 2% of the peak density is left
  glm::dvec3 max_extent{0.0};
  double min_radius = 0.0;  // [u]; of an ellipsoid each of its radii counts
  double max_radius = 0.0;
  double peak_density = 0.0;       // maximum b(x) found at a center, with b0
  double max_optical_depth = 0.0;  // maximum along a line, without b0
};

// The last two are lower bounds found by search: the density at centers, and the optical depth
// along lines through centers in 64 directions over the hemisphere, the best of which are refined
// by local search. At most 2e8 Gaussian evaluations: large media try only the centers of the
// largest radius * density (proportional to optical depth), with fewer directions and steps; ten
// million Gaussians, one center, nine directions and one round of steps. Deterministic.
MediumSummary summarize(const Medium& medium);

}  // namespace brume
