#pragma once

#include "brume/fit.h"
#include "core/io/volume/volume_file.h"

namespace brume {

// What is known of a volume before it is fitted.

// Whether its up axis is z rather than y: that of the two whose extent is less like that of x,
// which is horizontal in both. A plume is higher than wide, a cloud wider than high. If in doubt,
// it is y.
bool is_probably_z_up(const VolumeGridInfo& grid);

// What a fit will take, within a factor of about two.
struct FitCost {
  double seconds = 0.0;
  double bytes = 0.0;
};
// `blocks`: of the grid. `threads` work on it.
FitCost estimate_fit_cost(std::uint64_t blocks, const FitOptions& options, unsigned threads);

}  // namespace brume
