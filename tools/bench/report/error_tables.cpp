#include "tools/bench/report/error_tables.h"

#include <algorithm>

#include "tools/bench/measure/report_text.h"
#include "tools/bench/report/error_sections.h"

namespace brume {
ReportTable setting_table(const std::vector<SceneReport>& scenes) {
  struct Column {
    AirlightMethod method;
    int slices, scale;
  };
  constexpr Column columns[] = {{AirlightMethod::paper, 0, 1},
                                {AirlightMethod::sliced, 8, 1},
                                {AirlightMethod::sliced, 24, 1},
                                {AirlightMethod::sliced, 128, 1},
                                {AirlightMethod::sliced, 24, 4}};
  const auto find = [](const SceneReport& scene, const Column& column) {
    return std::ranges::find_if(scene.settings, [&](const Measurement& m) {
      return m.settings.airlight == column.method && m.settings.airlight_scale == column.scale &&
             (column.method == AirlightMethod::paper || m.settings.slices == column.slices);
    });
  };
  ReportTable table{"Error per setting", "", {"scene"}, {}, ""};
  for (const Column& column : columns) {
    const auto found = find(scenes[0], column);
    if (found == scenes[0].settings.end()) return {};
    table.heads.push_back(found->setting);
  }
  for (const SceneReport& scene : scenes) {
    auto& row = table.rows.emplace_back();
    row.push_back(formatted("%s: %zu Gaussians", scene.name.c_str(), scene.gaussians));
    for (const Column& column : columns) {
      row.push_back(formatted("%.2g%%", 100.0 * find(scene, column)->error.rel_rmse));
    }
  }
  return table;
}

std::vector<ReportTable> error_tables(const BenchReport& report) {
  std::vector<ReportTable> tables;
  visit_error_sections(report, [&](const char*, const auto& rows, const char* title,
                                   const char* lead, const auto&... columns) {
    ReportTable& table = tables.emplace_back(title, lead);
    table.heads = {columns.head...};
    for (const auto& row : rows) table.rows.push_back({columns.cell(row.*columns.value)...});
  });
  return tables;
}

ReportTable hard_case_table(const std::vector<HardCaseRow>& rows) {
  if (rows.empty()) return {};
  const bool with_gl = rows[0].errors.gl.has_value();
  ReportTable table{
      "Edge cases",
      formatted(
          "%zu scenes that break careless arithmetic (resources/hard_cases), compared with pixels "
          "computed independently to eleven digits. The columns are the relative RMSE of the "
          "airlight: of the reference, in double; of `sliced` with 24 slices, in float; of `auto` "
          "with a bound of %g%%; and of `paper` in float against the same in double. \"Reported\" "
          "means that `auto` warned that its error may exceed the bound. A test enforces these "
          "bounds: reference %g%%, `paper` %g%%, transmittance %g everywhere, `sliced` 1%% or the "
          "stated bound, `auto` its own bound unless it reported otherwise.",
          rows.size(), 100.0 * hard_case_max_error, 100.0 * hard_case_reference_bound,
          100.0 * hard_case_paper_bound, hard_case_transmittance_bound),
      {"case", "what breaks", "remedy", "reference", "sliced"},
      {},
      ""};
  if (with_gl) table.heads.emplace_back("OpenGL");
  table.heads.insert(table.heads.end(), {"auto", "paper", "bound of `sliced`"});
  for (const auto& [hard_case, errors] : rows) {
    std::vector<std::string> row = {hard_case.name, hard_case.breaks, hard_case.remedy,
                                    formatted("%.0g", errors.reference.airlight),
                                    formatted("%.2f%%", 100.0 * errors.sliced.airlight)};
    if (errors.gl) row.push_back(formatted("%.2f%%", 100.0 * errors.gl->airlight));
    row.push_back(formatted("%.2f%%", 100.0 * errors.automatic.airlight) +
                  (errors.automatic.is_told ? ", reported" : ""));
    row.push_back(formatted("%.0g", errors.paper));
    row.push_back(formatted("%g%%", 100.0 * hard_case.bound) +
                  (hard_case.why.empty() ? "" : ": " + hard_case.why));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace brume
