#include "tools/bench/speed_tables.h"

#include <algorithm>

#include "tools/bench/report_text.h"

namespace brume {
namespace {

// The cheapest row of each program that keeps an error, or else its most exact one.
std::vector<PeerRow> best_of_programs(const SceneReport& scene, double level) {
  std::vector<PeerRow> best;
  for (const PeerRow& row : scene.peers) {
    const auto known = std::ranges::find(best, row.program, &PeerRow::program);
    if (known == best.end()) {
      best.push_back(row);
      continue;
    }
    const bool keeps = row.rel_rmse <= level;
    const bool known_keeps = known->rel_rmse <= level;
    if (keeps && known_keeps ? row.cpu_milliseconds < known->cpu_milliseconds
                             : row.rel_rmse < known->rel_rmse) {
      *known = row;
    }
  }
  return best;
}

}  // namespace

ReportTable fastest_table(const std::vector<SceneReport>& scenes) {
  ReportTable table{
      "The fastest setting",
      "CPU milliseconds of a frame; the last column is what the reference would take.",
      {"scene"},
      {},
      ""};
  for (const double level : bench_error_levels) {
    table.heads.push_back(formatted("%g%%", 100.0 * level));
  }
  table.heads.emplace_back("reference");
  std::size_t marched = 0;
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
      marched += m.settings.airlight == AirlightMethod::march ? 1 : 0;
      row.push_back(m.setting + ": " + with_spread(m.cpu_milliseconds, 2));
    }
    row.push_back(formatted("%.0f", scene.reference_cpu_milliseconds));
  }
  table.remark = marched == 0
                     ? "Nowhere is it `march`."
                     : formatted("`march` is the fastest in %zu of these places.", marched);
  return table;
}

ReportTable peer_table(const std::vector<SceneReport>& scenes) {
  constexpr double level = 0.02;
  ReportTable table{
      "Other programs",
      "CPU time for the same picture, as `tools/compare-peers` measured it: the cheapest setting "
      "tried within 2%, or the most exact one where none is. The last column is that time over "
      "Brume's at 2%: over that of a frame with the camera moving, and over that of the first "
      "frame, which makes what the others keep.",
      {"scene", "Brume", "its first frame", "program", "setting", "CPU time", "error",
       "times Brume's"},
      {},
      ""};
  for (const SceneReport& scene : scenes) {
    const auto ours = cheapest_within(scene.settings, level);
    for (const PeerRow& peer : best_of_programs(scene, level)) {
      std::string setting = "none";
      std::string first;
      std::string times;
      if (ours) {
        const Measurement& m = scene.settings[*ours];
        setting = formatted("%s: %.2f ms", m.setting.c_str(), m.cpu_milliseconds.median);
        first = formatted("%.1f ms", m.first_cpu_milliseconds);
        times = formatted("%.0f, %.0f%s", peer.cpu_milliseconds / m.cpu_milliseconds.median,
                          peer.cpu_milliseconds / m.first_cpu_milliseconds,
                          peer.rel_rmse > level ? "; without keeping 2%" : "");
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
      "On " + report.gl_device + ", frames with the camera moving.",
      {"scene", "setting", "milliseconds", "on the processor", "error", "error there"},
      {},
      ""};
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
      "The scenes of the paper's Table 1",
      "Of its kinds and sizes, at 800 x 600, the airlight at every fourth pixel, the fewest slices "
      "that keep 2%; from frame to frame the camera turns around the scene by half a degree. The "
      "paper's frames per second are those of a GPU of 2007. The first 40 frames of a light also "
      "find out what lamps see of surfaces and what these send, for those after them to look up: "
      "how long these first ones take, and how far light so looked up is from light that is not, "
      "rms and at most, of the brightest channel of a pixel. What the kernel reaches is the least "
      "time of the view pass's arithmetic, on data in registers, over the view pass's time, on one "
      "thread.",
      {"scene", "frames per second", "the paper's", "setting", "error", "stages, ms",
       "first frames, ms", "looked up", "the kernel reaches"},
      {},
      ""};
  for (const TableOneRow& row : rows) {
    const Measurement& m = row.measurement;
    const Spread& ms = m.milliseconds;
    const Spread& reached = row.share.of_limit_with_pairs;
    table.rows.push_back(
        {row.name, with_spread({1e3 / ms.median, 1e3 / ms.greatest, 1e3 / ms.least}, 1),
         formatted("%.0f", row.paper_fps), m.setting, formatted("%.2f%%", 100.0 * m.error.rel_rmse),
         stage_times(m), with_spread(row.learning_milliseconds, 1),
         formatted("%.2g%%, %.2g%%", 100.0 * row.kept.rms, 100.0 * row.kept.greatest),
         formatted("%.0f%% (%.0f to %.0f)", 100.0 * reached.median, 100.0 * reached.least,
                   100.0 * reached.greatest)});
  }
  return table;
}

ReportTable curve_table(const std::vector<CostCurve>& curves) {
  ReportTable table{
      "How the cost grows",
      "A box of 1,000 Gaussians of constant depth, one lamp, 200 x 150 pixels, sliced 24, where "
      "one thing grows: CPU milliseconds of a frame.",
      {"over", "", "power"},
      {},
      ""};
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
                    "That box at 800 x 600.",
                    {"threads", "milliseconds of a frame", "times as fast as one"},
                    {},
                    ""};
  for (const ThreadRow& row : rows) {
    table.rows.push_back(
        {formatted("%d", row.threads), with_spread(row.milliseconds, 1),
         formatted("%.2f", rows[0].milliseconds.median / row.milliseconds.median)});
  }
  return table;
}

ReportTable saving_table(const std::vector<PlanSaving>& savings) {
  ReportTable table{
      "What a scene needs",
      "A stage that a scene does not need is left out. Beside it the same scene with as good as "
      "nothing for the stage to do (a billionth of a density, light or amplitude), so that it "
      "runs: CPU milliseconds of a frame of 200 x 150, and how far the pictures are apart.",
      {"stage", "left out because", "without", "with", "the picture changes by"},
      {},
      ""};
  for (const PlanSaving& saving : savings) {
    table.rows.push_back({saving.stage, saving.why, with_spread(saving.left_out, 2),
                          with_spread(saving.made, 2), formatted("%.0g", saving.change)});
  }
  return table;
}

}  // namespace brume
