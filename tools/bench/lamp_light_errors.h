#pragma once

#include <cstddef>
#include <vector>

#include "tools/bench/compared_error.h"

namespace brume {

// How far the light of a lamp that fog scatters onto surfaces is from Monte Carlo, and with the
// paper's one point spread function: a ball with the lamp in even fog, relative to what is
// scattered; balls in clouds of 30 Gaussians 3 deep with the lamp outside, relative to that and to
// all that they reflect. `samples`: of each run at each pixel, a tenth of them in clouds.
std::vector<ComparedError> measure_lamp_light(std::size_t samples);

}  // namespace brume
