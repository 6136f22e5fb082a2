#pragma once

#include <vector>

#include "tools/bench/report/bench_report.h"
#include "tools/bench/report/report_table.h"

namespace brume {

// Errors of pictures as tables; without rows where nothing was measured.

// One method and setting after the other, where they were all measured.
ReportTable setting_table(const std::vector<SceneReport>& scenes);

ReportTable thickness_table(const std::vector<ThicknessRow>& rows);
ReportTable sky_table(const std::vector<SkyRow>& rows);
ReportTable patch_table(const std::vector<ComparedError>& rows);
ReportTable inscattering_table(const std::vector<InscatteringRow>& rows);
ReportTable scale_table(const std::vector<ScaleRow>& rows);
ReportTable all_orders_table(const std::vector<AllOrdersRow>& rows);
ReportTable light_kind_table(const std::vector<LightKindRow>& rows);
ReportTable sample_table(const std::vector<SampleRow>& rows);
ReportTable noise_depth_table(const std::vector<NoiseDepthRow>& rows);
ReportTable noise_table(const std::vector<ComparedError>& rows);
ReportTable surface_light_table(const std::vector<ComparedError>& rows);
ReportTable incident_light_table(const std::vector<ComparedError>& rows);
ReportTable transfer_table(const std::vector<ComparedError>& rows);
ReportTable hard_case_table(const std::vector<HardCaseRow>& rows);

}  // namespace brume
