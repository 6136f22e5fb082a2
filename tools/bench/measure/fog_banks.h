#pragma once

#include <cstddef>
#include <vector>

#include "tools/bench/measure/measurement.h"

namespace brume {

// A bank of many small Gaussians that fills the view of 800 x 600, with the fewest slices for 2%.
struct FogBankRow {
  int gaussians = 0;
  std::size_t merged = 0;  // into as many; 0: not
  Measurement measurement{};
  Spread unmerged_ratio{};  // frame times without merging over those with
};

std::vector<FogBankRow> measure_fog_banks(bool quick);

}  // namespace brume
