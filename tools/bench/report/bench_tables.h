#pragma once

#include <string>
#include <vector>

#include "tools/bench/report/bench_report.h"
#include "tools/bench/report/report_table.h"

namespace brume {

inline constexpr char bench_title[] = "Speed against error";

// The lead of the page: what was measured, on what, and how.
std::string bench_lead(const BenchReport& report);

// All that was measured, in the order of the page; what was not has no table.
std::vector<ReportTable> bench_tables(const BenchReport& report);

}  // namespace brume
