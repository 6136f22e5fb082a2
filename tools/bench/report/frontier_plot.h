#pragma once

#include <string>

#include "tools/bench/report/bench_report.h"

namespace brume {

// The CPU time of a scene's settings, of the reference and of other programs against their error,
// as SVG. `with_legend`: what the colours mean is in it.
std::string frontier_plot(const SceneReport& scene, bool with_legend = false);

}  // namespace brume
