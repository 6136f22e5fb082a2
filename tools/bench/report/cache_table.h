#pragma once

#include <vector>

#include "tools/bench/measure/cache_gains.h"
#include "tools/bench/report/report_table.h"

namespace brume {

// Frames per second that a cache has to give in one scene, unless it takes fewer lines than these
// and changes no picture.
inline constexpr double min_cache_gain = 0.25;
inline constexpr int small_cache_lines = 20;

// Caches between frames, and which of them give too little.
ReportTable cache_table(const std::vector<CacheGain>& gains);

}  // namespace brume
