#pragma once

#include <vector>

#include "tools/bench/bench_report.h"
#include "tools/bench/report_table.h"

namespace brume {

// How wrong pictures are, as tables; without rows where nothing was measured.

// One method and setting after the other, where they were all measured.
ReportTable setting_table(const std::vector<SceneReport>& scenes);

ReportTable thickness_table(const std::vector<ThicknessRow>& rows);
ReportTable sky_table(const std::vector<SkyRow>& rows);
ReportTable hard_case_table(const std::vector<HardCaseRow>& rows);

}  // namespace brume
