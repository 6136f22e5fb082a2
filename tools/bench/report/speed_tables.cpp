#include "tools/bench/report/speed_tables.h"

#include <algorithm>

#include "tools/bench/measure/report_text.h"

namespace brume {
namespace {

// The cheapest row of each program that meets an error bound, or else its most exact one.
std::vector<OtherRendererRow> best_of_programs(const SceneReport& scene, double level) {
  std::vector<OtherRendererRow> best;
  for (const OtherRendererRow& row : scene.peers) {
    const auto it = std::ranges::find(best, row.program, &OtherRendererRow::program);
    if (it == best.end()) {
      best.push_back(row);
      continue;
    }
    const bool meets = row.rel_rmse <= level;
    const bool known_keeps = it->rel_rmse <= level;
    if (meets && known_keeps ? row.cpu_milliseconds < it->cpu_milliseconds
                             : row.rel_rmse < it->rel_rmse) {
      *it = row;
    }
  }
  return best;
}

}  // namespace

ReportTable fastest_table(const std::vector<SceneReport>& scenes) {
  ReportTable table{
      "Fastest setting per error bound",
      "CPU milliseconds per frame of the fastest setting that meets each error bound. The last "
      "column is the time that the reference would take.",
      {"scene"}};
  for (const double level : bench_error_levels) {
    table.heads.push_back(formatted("%g%%", 100.0 * level));
  }
  table.heads.emplace_back("reference");
  for (const SceneReport& scene : scenes) {
    auto& row = table.rows.emplace_back();
    row.push_back(formatted("%s: %zu Gaussians", scene.name.c_str(), scene.gaussians));
    for (const double level : bench_error_levels) {
      const auto best = cheapest_within(scene.settings, level);
      if (!best) {
        row.emplace_back("none");
        continue;
      }
      const Measurement& m = scene.settings[*best];
      row.push_back(m.setting + ": " + with_spread(m.cpu_milliseconds, 2));
    }
    row.push_back(formatted("%.0f", scene.reference_cpu_milliseconds));
  }
  return table;
}

ReportTable peer_table(const std::vector<SceneReport>& scenes) {
  constexpr double level = 0.02;
  ReportTable table{
      "Other renderers",
      "CPU time for the same picture, measured by `tools/compare-peers`: the cheapest setting "
      "within 2%, or the most accurate one if none is. The last column divides it by Brume's time "
      "at 2%: by that of a frame with a moving camera, and by that of the first frame, which also "
      "builds the caches of later ones.",
      {"scene", "Brume", "first frame", "renderer", "setting", "CPU time", "error",
       "ratio to Brume"}};
  for (const SceneReport& scene : scenes) {
    const auto ours = cheapest_within(scene.settings, level);
    for (const OtherRendererRow& peer : best_of_programs(scene, level)) {
      std::string setting = "none";
      std::string first;
      std::string times;
      if (ours) {
        const Measurement& m = scene.settings[*ours];
        setting = formatted("%s: %.2f ms", m.setting.c_str(), m.cpu_milliseconds.median);
        first = formatted("%.1f ms", m.first_cpu_milliseconds);
        times = formatted("%.0f, %.0f%s", peer.cpu_milliseconds / m.cpu_milliseconds.median,
                          peer.cpu_milliseconds / m.first_cpu_milliseconds,
                          peer.rel_rmse > level ? "; does not meet 2%" : "");
      }
      table.rows.push_back({scene.name, setting, first, peer.program, peer.setting,
                            formatted("%.2f s", 1e-3 * peer.cpu_milliseconds),
                            formatted("%.1f%%", 100.0 * peer.rel_rmse), times});
    }
  }
  return table;
}

ReportTable gl_table(const BenchReport& report) {
  ReportTable table{
      "OpenGL",
      "On " + report.gl_device + ", frames with a moving camera.",
      {"scene", "setting", "milliseconds", "on the CPU", "error", "error on the CPU"}};
  for (const SceneReport& scene : report.scenes) {
    for (const Measurement& m : scene.on_gl) {
      const auto cpu = std::ranges::find(scene.settings, m.settings, &Measurement::settings);
      table.rows.push_back({scene.name, m.setting, with_spread(m.milliseconds, 2),
                            formatted("%.2f", cpu->milliseconds.median),
                            formatted("%.2f%%", 100.0 * m.error.rel_rmse),
                            formatted("%.2f%%", 100.0 * cpu->error.rel_rmse)});
    }
  }
  return table;
}

ReportTable table_one_table(const std::vector<TableOneRow>& rows) {
  ReportTable table{
      "Scenes like those of the paper's Table 1",
      "The same kinds and sizes, at 800 x 600 with airlight scale 4 and the fewest slices that "
      "meet 2%. The camera orbits the scene by half a degree per frame. The paper's frame rates "
      "are those of a GPU of 2007. All orders is the time of a frame with all orders of "
      "scattering over that of one with light scattered once, as measured in turn.",
      {"scene", "frames per second", "paper", "setting", "error", "stages, ms", "all orders"}};
  for (const TableOneRow& row : rows) {
    const Measurement& m = row.measurement;
    const Spread& ms = m.milliseconds;
    table.rows.push_back({row.name, with_spread({1e3 / ms.median, 1e3 / ms.max, 1e3 / ms.min}, 1),
                          formatted("%.0f", row.paper_fps), m.setting,
                          formatted("%.2f%%", 100.0 * m.error.rel_rmse), stage_times(m),
                          with_spread(row.all_orders_ratio, 2)});
  }
  return table;
}

ReportTable curve_table(const std::vector<CostCurve>& curves) {
  ReportTable table{
      "Cost scaling",
      "CPU milliseconds per frame for a box of 1,000 Gaussians of constant optical depth, with one "
      "light, 200 x 150 pixels and sliced 24, as one quantity grows. The exponent is that of a "
      "power law.",
      {"quantity", "", "exponent"}};
  for (const CostCurve& curve : curves) {
    std::string points;
    for (const CostPoint& p : curve.points) {
      put(points, "%s%.0f: %.1f", points.empty() ? "" : ", ", p.size, p.cpu_milliseconds);
    }
    table.rows.push_back({curve.over, points, formatted("%.2f", curve.exponent)});
  }
  return table;
}

ReportTable thread_table(const std::vector<ThreadRow>& rows) {
  ReportTable table{"Threads",
                    "The same box at 800 x 600.",
                    {"threads", "milliseconds per frame", "speed-up over one"}};
  for (const ThreadRow& row : rows) {
    table.rows.push_back(
        {formatted("%d", row.threads), with_spread(row.milliseconds, 1),
         formatted("%.2f", rows[0].milliseconds.median / row.milliseconds.median)});
  }
  return table;
}

ReportTable fog_bank_table(const std::vector<FogBankRow>& rows) {
  ReportTable table{
      "Many Gaussians",
      "Banks of small Gaussians that fill the view, at 800 x 600 and airlight scale 4, with the "
      "fewest slices for an error of 2%. Merged: into how many Gaussians, as `sliced` with few "
      "slices does where that is faster.",
      {"Gaussians", "setting", "merged", "milliseconds per frame", "error",
       "unmerged, times slower"}};
  for (const FogBankRow& row : rows) {
    table.rows.push_back({formatted("%d", row.gaussians), row.measurement.setting,
                          row.merged > 0 ? formatted("%zu", row.merged) : "no",
                          with_spread(row.measurement.milliseconds, 1),
                          formatted("%.2f%%", 100.0 * row.measurement.error.rel_rmse),
                          with_spread(row.unmerged_ratio, 2)});
  }
  return table;
}

ReportTable saving_table(const std::vector<PlanSaving>& savings) {
  ReportTable table{
      "Skipped stages",
      "Stages that a scene does not need are skipped. For comparison, the same scene with almost "
      "nothing for the stage to do (a density, light or amplitude of a billionth), so that it "
      "runs. CPU milliseconds per frame of 200 x 150, and the relative difference of the pictures.",
      {"stage", "skipped because", "skipped", "run", "difference"}};
  for (const PlanSaving& saving : savings) {
    table.rows.push_back({to_string(saving.stage), saving.why, with_spread(saving.left_out, 2),
                          with_spread(saving.made, 2), formatted("%.0g", saving.change)});
  }
  return table;
}

}  // namespace brume
