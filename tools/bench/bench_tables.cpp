#include "tools/bench/bench_tables.h"

#include "tools/bench/device_name.h"
#include "tools/bench/error_tables.h"
#include "tools/bench/report_text.h"
#include "tools/bench/speed_tables.h"

namespace brume {

std::string bench_lead(const BenchReport& report) {
  return formatted(
      "This page is what `%s` writes: version %s, %s, %d threads. Times are medians of frames with "
      "the camera moving, their least and greatest in parentheses; CPU time is that of all threads "
      "together. An error is the relative RMSE of the airlight against the converged integral, "
      "measured on the same frames; a setting keeps an error if the upper end of the error's 95%% "
      "interval does.",
      report.command.c_str(), BRUME_VERSION, device_name().c_str(), report.threads);
}

std::vector<ReportTable> bench_tables(const BenchReport& report) {
  std::vector<ReportTable> tables = {fastest_table(report.scenes),
                                     setting_table(report.scenes),
                                     thickness_table(report.thickness),
                                     sky_table(report.skies),
                                     patch_table(report.patches),
                                     glow_table(report.glow),
                                     scale_table(report.scales),
                                     noise_depth_table(report.noise_depths),
                                     noise_table(report.noise),
                                     lamp_light_table(report.lamp_light),
                                     arriving_light_table(report.arriving_light),
                                     transfer_table(report.transfer),
                                     peer_table(report.scenes),
                                     gl_table(report),
                                     table_one_table(report.table_one),
                                     curve_table(report.curves),
                                     thread_table(report.thread_rows),
                                     saving_table(report.savings),
                                     hard_case_table(report.hard_cases)};
  std::erase_if(tables, [](const ReportTable& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace brume
