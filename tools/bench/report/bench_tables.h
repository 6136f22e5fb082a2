#pragma once

#include <string>
#include <vector>

#include "tools/bench/measure/cache_gains.h"
#include "tools/bench/report/bench_report.h"

namespace brume {

// A table of a report, whatever it is written as. Texts are plain, with `code` in backticks.
struct ReportTable {
  std::string title;  // of its section; empty: it belongs to the section of the table before it
  std::string lead;   // what it shows
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows{};  // of as many cells as there are heads
  std::string remark{};                          // below it; empty: none
};

inline constexpr char bench_title[] = "Speed against error";

// The lead of the page: what was measured, on what, and how.
std::string bench_lead(const BenchReport& report);

// All that was measured, in the order of the page; what was not has no table.
std::vector<ReportTable> bench_tables(const BenchReport& report);

// Frames per second that a cache has to give in one scene, unless it takes fewer lines than these
// and changes no picture.
inline constexpr double min_cache_gain = 0.25;
inline constexpr int small_cache_lines = 20;

// Caches between frames, and which of them give too little.
ReportTable cache_table(const std::vector<CacheGain>& gains);

}  // namespace brume
