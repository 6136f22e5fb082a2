#pragma once

#include <vector>

#include "tools/bench/report/bench_report.h"
#include "tools/bench/report/bench_tables.h"

namespace brume {

// Tables of the cost of pictures; without rows where nothing was measured.

ReportTable fastest_table(const std::vector<SceneReport>& scenes);

// The cheapest setting of each other program that meets 2%, or else its most exact one.
ReportTable peer_table(const std::vector<SceneReport>& scenes);

ReportTable gl_table(const BenchReport& report);
ReportTable table_one_table(const std::vector<TableOneRow>& rows);
ReportTable curve_table(const std::vector<CostCurve>& curves);
ReportTable thread_table(const std::vector<ThreadRow>& rows);
ReportTable fog_bank_table(const std::vector<FogBankRow>& rows);
ReportTable saving_table(const std::vector<PlanSaving>& savings);

}  // namespace brume
