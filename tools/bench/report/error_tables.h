#pragma once

#include <vector>

#include "tools/bench/report/bench_report.h"
#include "tools/bench/report/report_table.h"

namespace brume {

// Errors of pictures as tables; without rows where nothing was measured.

// One method and setting after the other, where they were all measured.
ReportTable setting_table(const std::vector<SceneReport>& scenes);

// Those of the sections that error_sections.h describes, in their order.
std::vector<ReportTable> error_tables(const BenchReport& report);
ReportTable hard_case_table(const std::vector<HardCaseRow>& rows);

}  // namespace brume
