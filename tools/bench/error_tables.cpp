#include "tools/bench/error_tables.h"

#include <algorithm>

#include "tools/bench/report_text.h"

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
  ReportTable table{"The error of a setting", "", {"scene"}, {}, ""};
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

ReportTable thickness_table(const std::vector<ThicknessRow>& rows) {
  ReportTable table{"Thin and thick fog",
                    "The sample scene dense_cloud, all densities times a factor.",
                    {"factor", "greatest optical depth", "`paper`", "`sliced` 24"},
                    {},
                    ""};
  for (const ThicknessRow& row : rows) {
    table.rows.push_back({formatted("%g", row.factor), formatted("%.2g", row.greatest_depth),
                          with_interval(row.paper), with_interval(row.sliced)});
  }
  return table;
}

ReportTable sky_table(const std::vector<SkyRow>& rows) {
  ReportTable table{"Light of an environment",
                    "The error of `sliced` 24 in clouds that only a sky lights: an even one, and "
                    "one that is brighter above and has a sun.",
                    {"Gaussians", "optical depth", "anisotropy", "even sky", "sky with a sun"},
                    {},
                    ""};
  for (const SkyRow& row : rows) {
    table.rows.push_back({formatted("%d", row.gaussians), formatted("%g", row.depth),
                          formatted("%g", row.anisotropy), with_interval(row.even),
                          with_interval(row.sunny)});
  }
  return table;
}

ReportTable hard_case_table(const std::vector<HardCaseRow>& rows) {
  if (rows.empty()) return {};
  const bool with_gl = rows[0].errors.gl.has_value();
  ReportTable table{
      "Hard cases",
      formatted(
          "%zu scenes that break careless arithmetic (resources/hard_cases), against what their "
          "pixels are, computed elsewhere to eleven digits: the relative RMSE of the airlight of "
          "the reference, in double, and of `sliced` with 24 slices, in float; the last number is "
          "that of `paper` in float against the same in double. A test holds them to these bounds: "
          "reference %g%%, paper %g%%, transmittance everywhere %g, `sliced` 1%% or what is "
          "stated.",
          rows.size(), 100.0 * hard_case_reference_bound, 100.0 * hard_case_paper_bound,
          hard_case_transmittance_bound),
      {"case", "what breaks", "what Brume does", "reference", "sliced"},
      {},
      ""};
  if (with_gl) table.heads.emplace_back("OpenGL");
  table.heads.insert(table.heads.end(), {"paper", "bound"});
  for (const auto& [hard_case, errors] : rows) {
    std::vector<std::string> row = {hard_case.name, hard_case.breaks, hard_case.remedy,
                                    formatted("%.0g", errors.reference.airlight),
                                    formatted("%.2f%%", 100.0 * errors.sliced.airlight)};
    if (errors.gl) row.push_back(formatted("%.2f%%", 100.0 * errors.gl->airlight));
    row.push_back(formatted("%.0g", errors.paper));
    row.push_back(formatted("%g%%", 100.0 * hard_case.bound) +
                  (hard_case.why.empty() ? "" : ": " + hard_case.why));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace brume
