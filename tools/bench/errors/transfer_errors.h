#pragma once

#include <cstddef>
#include <vector>

#include "tools/bench/errors/compared_error.h"

namespace brume {

// Error of light reflected by an object with radiance transfer against Monte Carlo; `other`: the
// same without it. Cases: the floor under a ball in a smooth sky; a bowl in fog under a point
// light; and, without `other`, interreflection in a bowl of radius 1 for lights at several
// distances, up to two further bounces. `samples`: per run and pixel.
std::vector<ComparedError> measure_transfer(std::size_t samples);

}  // namespace brume
