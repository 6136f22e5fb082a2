#pragma once

#include <glm/vec3.hpp>

#include "core/medium/medium.h"

namespace brume {

// What a medium holds, in numbers. The zeros stand where it has no Gaussians.
struct MediumSummary {
  glm::dvec3 least_center{0.0};  // bounds of the centres [u]
  glm::dvec3 greatest_center{0.0};
  glm::dvec3 least_extent{0.0};  // bounds of centre -+ 2 radius, beyond which 2% of a peak is left
  glm::dvec3 greatest_extent{0.0};
  double least_radius = 0.0;  // [u]
  double greatest_radius = 0.0;
  double peak_density = 0.0;            // the greatest b(x) found at a centre, with b0 [1/u]
  double greatest_optical_depth = 0.0;  // of the Gaussians alone, along a whole line
};

// The last two are found by search, so they are lower bounds: the density at the centres, and the
// optical depth along lines through the centres in 64 directions spread evenly over the half
// sphere, the best of which are moved and turned until no small step makes them deeper. The search
// evaluates at most 2e8 Gaussians in all. Where there are many, only the centres of the greatest
// radius * density (the optical depth of one Gaussian) are tried, and fewer directions and steps:
// of ten million Gaussians, one centre, nine directions and one round of steps. Deterministic.
MediumSummary summarize(const Medium& medium);

}  // namespace brume
