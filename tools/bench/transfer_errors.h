#pragma once

#include <cstddef>
#include <vector>

#include "tools/bench/compared_error.h"

namespace brume {

// How far what an object with radiance transfer reflects is from Monte Carlo; `other` is the same
// object without it: the floor under a ball, in a smooth sky; a bowl in fog that a lamp lights;
// and, without `other`, what the walls of a bowl of radius 1 reflect onto each other of the light
// of lamps at some distances, by two more reflections at most. `samples`: of each run at each
// pixel.
std::vector<ComparedError> measure_transfer(std::size_t samples);

}  // namespace brume
