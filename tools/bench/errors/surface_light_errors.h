#pragma once

#include <cstddef>
#include <vector>

#include "tools/bench/errors/compared_error.h"

namespace brume {

// Error of point light scattered onto surfaces by fog against Monte Carlo, and with the paper's
// single point spread function: a ball with the light in homogeneous fog, relative to the scattered
// light; balls in clouds of 30 Gaussians of optical depth 3 with the light outside, relative to
// that and to all reflected light. `samples`: per run and pixel, a tenth of them in clouds.
std::vector<ComparedError> measure_surface_light(std::size_t samples);

}  // namespace brume
