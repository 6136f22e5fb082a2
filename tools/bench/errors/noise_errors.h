#pragma once

#include <vector>

#include "tools/bench/errors/compared_error.h"
#include "tools/bench/measure/measurement.h"

namespace brume {

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
