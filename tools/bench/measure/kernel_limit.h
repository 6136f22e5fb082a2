#pragma once

#include "tools/bench/measure/measurement.h"

namespace brume {

// How near the inner loops of `sliced` come to what the machine can do, on the tiles of a frame,
// on one thread.
struct KernelShare {
  // Arithmetic alone, on data in registers: increments (the depth of one Gaussian on one slice of
  // one ray) per second.
  Spread limit_per_second;
  // Increments per second of the view pass over that limit. An increment counts in all lanes of a
  // vector where one lane needs it.
  Spread of_limit;
  // Lower bound of the time of increments and of pairs (Gaussian x ray), relative to the view pass:
  // where Gaussians are as small as slices, much of the arithmetic is per pair.
  Spread of_limit_with_pairs;
  // Time of the sum over slices with tables of lights and shadows that fit into the L1 cache, over
  // its time with the real ones.
  Spread sum_of_limit;
  double increments_per_pair = 0.0;
  double used_lanes = 0.0;  // increments that lanes need, over those computed
};

KernelShare measure_kernel_share(const Scene& scene, const Settings& settings, int rounds);

}  // namespace brume
