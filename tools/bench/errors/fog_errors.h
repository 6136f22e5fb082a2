#pragma once

#include <string>
#include <vector>

#include "render/quality/error_estimate.h"
#include "tools/bench/errors/unbiased_error.h"
#include "tools/bench/measure/measurement.h"

namespace brume {

// How the errors of `paper`, as published and conserving energy, and of `sliced` with 24 slices, go
// with the thickness of the fog: resources/scenes/dense_cloud with all densities times a factor.
struct ThicknessRow {
  double factor = 1.0;
  double max_depth = 0.0;
  ErrorEstimate paper, energy, sliced;
};
std::vector<ThicknessRow> measure_thickness(std::size_t pixels);

// Errors of `sliced` with 24 slices in clouds that only an environment lights: an even sky, and one
// with a sun.
struct SkyRow {
  int gaussians = 0;
  double depth = 0.0;
  double anisotropy = 0.0;
  ErrorEstimate even, sunny;
};
std::vector<SkyRow> measure_skies();

// Where the grid of an environment's light is worst: small Gaussians in patches over a landscape
// (resources/scenes/ground_fog) under a sun near the horizon, with `sliced` of 12, 24 and 64 slices
// and the grids that go with them; and in fog that turns light little, with 24.
std::vector<ComparedError> measure_patches();

// The glow of `paper` (eq. 28) in the middle of a Gaussian before a white sky, over what single
// scattering gives there.
struct InscatteringRow {
  double depth = 0.0;
  double share = 0.0;
};
std::vector<InscatteringRow> measure_inscattering();

// The work at 800 x 600 where the airlight is interpolated, and what that changes: `sliced`
// with 24 slices, at every second and fourth pixel, against every pixel.
struct ScaleRow {
  std::string scene;
  int scale = 1;
  double computed = 1.0;  // share of the pixels
  double change = 0.0;    // relative rms
};
std::vector<ScaleRow> measure_scales();

// Changes by noise (section 5.5 of the paper) that should not be.

// How much the optical depth, averaged over a picture of a cloud of 30 Gaussians, changes by noise
// of the amplitude 0.5: over eight seeds, from afar and from near.
struct NoiseDepthRow {
  double cells = 0.0;  // of the noise, per u
  Spread afar, near;   // relative, signed
};
std::vector<NoiseDepthRow> measure_noise_depths();

// Errors of `sliced` with 24 slices in noise; `other` is that of the same fog without it.
std::vector<ComparedError> measure_noise_errors(std::size_t pixels);

}  // namespace brume
