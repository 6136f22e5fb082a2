#pragma once

#include <cstddef>
#include <vector>

#include "brume/scene.h"
#include "tools/bench/errors/unbiased_error.h"

namespace brume {

// Error of light reflected by an object with radiance transfer against Monte Carlo; `other`: the
// same without it. Cases: the floor under a ball in a smooth sky; a bowl in fog under a point
// light; and, without `other`, interreflection in a bowl of radius 1 for lights at several
// distances, up to two further bounces. `samples`: per run and pixel.
std::vector<ComparedError> measure_transfer(std::size_t samples);

// Objects that shadow and light themselves, without any light.

// A hollow ball of radius 1, open at the top from the polar angle `to`, seen from above.
Scene bowl_scene(double to, Surface::Transfer transfer);

// A ball over a floor in one mesh; the floor is at z = 0.
Scene ball_over_floor(Surface::Transfer transfer);

}  // namespace brume
