#pragma once

#include <vector>

#include "brume/frame.h"
#include "render/grid/ordinates.h"
#include "render/settings.h"
#include "render/util/job.h"

namespace brume {

// All orders of scattering in a medium on a grid, by discrete ordinates with the first collisions
// as source.

// A medium in which the part of the phase function beyond `bands` counts as not scattered at all:
// delta-M truncation (Wiscombe 1977).
struct TruncatedScattering {
  double extinction = 1.0;    // relative to the medium's
  double albedo = 1.0;        // in [0, 1]
  std::vector<double> phase;  // its bands, phase[0] = 1

  // Forward lobes only: a backward one is cut off after the bands. Where the albedo varies, what
  // the lobe takes from the extinction would vary, too: then both are cut off.
  TruncatedScattering(double albedo, double anisotropy, int bands, bool albedo_varies);
};

// The degrees of the quadrature rules of the sweeps' directions.
struct SweepDegrees {
  int first;  // of light scattered for the first time
  int rest;
};

// Light that was not scattered yet: at the nodes, and as surfaces have reflected it, see
// reflected_light().
struct UnscatteredLight {
  NodeLight incident;
  std::vector<float> reflected;
};

// Solves M = w P K (U + M) for M, the light at the nodes that was scattered or reflected at least
// once: K is transport through `medium`, whose density is the truncated extinction, P the phase
// function, U the light that was not. `scattered` has the bands of U, at least those of the phase
// function, and holds a first guess, or nothing.
Convergence solve_scattering(const GridMedium& medium, const TruncatedScattering& scattering,
                             const UnscatteredLight& unscattered, const SweepDegrees& degrees,
                             const ScatteringLimits& limits, NodeLight& scattered, const Job& job);

}  // namespace brume
