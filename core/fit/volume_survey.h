#pragma once

#include "brume/fit.h"
#include "core/io/volume/volume_file.h"

namespace brume {

// These functions tell what is known of a volume before it is fitted.

// Whether its up axis is z rather than y: the extents in x and y are alike, as horizontal ones are,
// and the one in z is much larger (a plume) or smaller (a cloud). If in doubt, it is y.
bool is_probably_z_up(const VolumeGridInfo& grid);

// Time and memory that a fit will take, within a factor of about two.
struct FitCost {
  double seconds = 0.0;
  double bytes = 0.0;
};
// The cost for a grid of so many blocks, on so many threads.
FitCost estimate_fit_cost(std::uint64_t blocks, const FitOptions& options, unsigned threads);

}  // namespace brume
