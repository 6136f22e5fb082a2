#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/bench/bench_run.h"

namespace brume {

// Varies one parameter at a time; base scene: the box of 1,000 Gaussians with one light, sliced 24.
std::vector<CostCurve> measure_cost_curves(const BenchOptions& options,
                                           const std::function<void(const std::string&)>& log);

// That box at 800 x 600, with 1, 2, 4 ... threads and with all.
std::vector<ThreadRow> measure_threads(const BenchOptions& options);

}  // namespace brume
