#include "tools/bench/bench_markdown.h"

#include <algorithm>
#include <optional>

#include "tools/bench/device_name.h"
#include "tools/bench/log_plot.h"

namespace brume {
namespace {

void put_head(const BenchReport& report, std::string& page) {
  put(page,
      "# Speed against error\n\nThis page is what `%s` writes: version %s, %s, %d threads. Times "
      "are medians of frames with the camera moving, their least and greatest in parentheses; CPU "
      "time is that of all threads together. An error is the relative RMSE of the airlight against "
      "the converged integral, measured on the same frames; a setting keeps an error if the upper "
      "end of the error's 95%% interval does.\n",
      report.command.c_str(), BRUME_VERSION, device_name().c_str(), report.threads);
}

std::string scene_words(const SceneReport& scene) {
  std::string words;
  put(words, "%s: %zu Gaussians", scene.name.c_str(), scene.gaussians);
  return words;
}

void put_fastest(const std::vector<SceneReport>& scenes, std::string& page) {
  page +=
      "\n## The fastest setting\n\nCPU milliseconds of a frame; the last column is what the "
      "reference would take.\n\n| scene |";
  for (const double level : bench_error_levels) put(page, " %g%% |", 100.0 * level);
  page += " reference |\n|---|";
  for (std::size_t i = 0; i <= bench_error_levels.size(); ++i) page += "---|";
  page += '\n';
  std::size_t marched = 0;
  for (const SceneReport& scene : scenes) {
    put(page, "| %s |", scene_words(scene).c_str());
    for (const double level : bench_error_levels) {
      const auto best = cheapest_within(scene.settings, level);
      if (!best) {
        page += " none |";
        continue;
      }
      const Measurement& m = scene.settings[*best];
      marched += m.settings.airlight == AirlightMethod::march ? 1 : 0;
      put(page, " %s: %.2f (%.2f to %.2f) |", m.setting.c_str(), m.cpu_milliseconds.median,
          m.cpu_milliseconds.least, m.cpu_milliseconds.greatest);
    }
    put(page, " %.0f |\n", scene.reference_cpu_milliseconds);
  }
  if (marched == 0) {
    page += "\nNowhere is it `march`.\n";
  } else {
    put(page, "\n`march` is the fastest in %zu of these places.\n", marched);
  }
}

struct Column {
  AirlightMethod method;
  int slices, scale;
};

// Errors of one method and setting after the other, where they were all measured.
void put_errors(const std::vector<SceneReport>& scenes, std::string& page) {
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
  for (const Column& column : columns) {
    if (find(scenes[0], column) == scenes[0].settings.end()) return;
  }
  page += "\n## The error of a setting\n\n| scene |";
  for (const Column& column : columns) {
    put(page, " %s |", find(scenes[0], column)->setting.c_str());
  }
  page += "\n|---|---|---|---|---|---|\n";
  for (const SceneReport& scene : scenes) {
    put(page, "| %s |", scene_words(scene).c_str());
    for (const Column& column : columns) {
      put(page, " %.2g%% |", 100.0 * find(scene, column)->error.rel_rmse);
    }
    page += '\n';
  }
}

// The cheapest row of each program that keeps 2%, or else its most exact one.
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

void put_peers(const std::vector<SceneReport>& scenes, std::string& page) {
  if (std::ranges::all_of(scenes, [](const SceneReport& s) { return s.peers.empty(); })) return;
  constexpr double level = 0.02;
  page +=
      "\n## Other programs\n\nCPU time for the same picture, as `tools/compare-peers` measured it: "
      "the cheapest setting tried within 2%, or the most exact one where none is. The last column "
      "is that time over Brume's at 2%: over that of a frame with the camera moving, and over that "
      "of "
      "the first frame, which makes what the others keep.\n\n"
      "| scene | Brume | its first frame | program | setting | CPU time | error | times Brume's |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const SceneReport& scene : scenes) {
    const auto ours = cheapest_within(scene.settings, level);
    for (const PeerRow& peer : best_of_programs(scene, level)) {
      put(page, "| %s |", scene.name.c_str());
      if (ours) {
        const Measurement& m = scene.settings[*ours];
        put(page, " %s: %.2f ms | %.1f ms |", m.setting.c_str(), m.cpu_milliseconds.median,
            m.first_cpu_milliseconds);
      } else {
        page += " none | |";
      }
      put(page, " %s | %s | %.2f s | %.1f%% |", peer.program.c_str(), peer.setting.c_str(),
          1e-3 * peer.cpu_milliseconds, 100.0 * peer.rel_rmse);
      if (ours) {
        const Measurement& m = scene.settings[*ours];
        put(page, " %.0f, %.0f%s |\n", peer.cpu_milliseconds / m.cpu_milliseconds.median,
            peer.cpu_milliseconds / m.first_cpu_milliseconds,
            peer.rel_rmse > level ? "; without keeping 2%" : "");
      } else {
        page += " |\n";
      }
    }
  }
}

void put_gl(const BenchReport& report, std::string& page) {
  if (report.gl_device.empty()) return;
  put(page, "\n## OpenGL\n\nOn %s, frames with the camera moving.\n\n", report.gl_device.c_str());
  page +=
      "| scene | setting | milliseconds | on the processor | error | error there |\n"
      "|---|---|---|---|---|---|\n";
  for (const SceneReport& scene : report.scenes) {
    for (const Measurement& m : scene.on_gl) {
      const auto cpu = std::ranges::find(scene.settings, m.settings, &Measurement::settings);
      put(page, "| %s | %s | %.2f (%.2f to %.2f) | %.2f | %.2f%% | %.2f%% |\n", scene.name.c_str(),
          m.setting.c_str(), m.milliseconds.median, m.milliseconds.least, m.milliseconds.greatest,
          cpu->milliseconds.median, 100.0 * m.error.rel_rmse, 100.0 * cpu->error.rel_rmse);
    }
  }
}

void put_thickness(const std::vector<ThicknessRow>& rows, std::string& page) {
  if (rows.empty()) return;
  page +=
      "\n## Thin and thick fog\n\nThe sample scene dense_cloud, all densities times a factor.\n\n"
      "| factor | greatest optical depth | `paper` | `sliced` 24 |\n|---|---|---|---|\n";
  for (const ThicknessRow& row : rows) {
    put(page, "| %g | %.2g | %.2g%% (%.2g to %.2g) | %.2g%% (%.2g to %.2g) |\n", row.factor,
        row.greatest_depth, 100.0 * row.paper.rel_rmse, 100.0 * row.paper.low,
        100.0 * row.paper.high, 100.0 * row.sliced.rel_rmse, 100.0 * row.sliced.low,
        100.0 * row.sliced.high);
  }
}

void put_skies(const std::vector<SkyRow>& rows, std::string& page) {
  if (rows.empty()) return;
  page +=
      "\n## Light of an environment\n\nThe error of `sliced` 24 in clouds that only a sky lights: "
      "an even one, and one that is brighter above and has a sun.\n\n"
      "| Gaussians | optical depth | anisotropy | even sky | sky with a sun |\n"
      "|---|---|---|---|---|\n";
  for (const SkyRow& row : rows) {
    put(page, "| %d | %g | %g | %.2g%% (%.2g to %.2g) | %.2g%% (%.2g to %.2g) |\n", row.gaussians,
        row.depth, row.anisotropy, 100.0 * row.even.rel_rmse, 100.0 * row.even.low,
        100.0 * row.even.high, 100.0 * row.sunny.rel_rmse, 100.0 * row.sunny.low,
        100.0 * row.sunny.high);
  }
}

void put_curves(const std::vector<CostCurve>& curves, std::string& page) {
  if (curves.empty()) return;
  page +=
      "\n## How the cost grows\n\nA box of 1,000 Gaussians of constant depth, one lamp, 200 x 150 "
      "pixels, sliced 24, where one thing grows: CPU milliseconds of a frame.\n\n"
      "| over | | power |\n|---|---|---|\n";
  for (const CostCurve& curve : curves) {
    put(page, "| %s |", curve.over.c_str());
    const char* separator = " ";
    for (const CostPoint& p : curve.points) {
      put(page, "%s%.0f: %.1f", separator, p.size, p.cpu_milliseconds);
      separator = ", ";
    }
    put(page, " | %.2f |\n", curve.exponent);
  }
}

void put_threads(const std::vector<ThreadRow>& rows, std::string& page) {
  if (rows.empty()) return;
  page +=
      "\n## Threads\n\nThat box at 800 x 600.\n\n| threads | milliseconds of a frame | times as "
      "fast as one |\n|---|---|---|\n";
  for (const ThreadRow& row : rows) {
    put(page, "| %d | %.1f (%.1f to %.1f) | %.2f |\n", row.threads, row.milliseconds.median,
        row.milliseconds.least, row.milliseconds.greatest,
        rows[0].milliseconds.median / row.milliseconds.median);
  }
}

void put_table_one(const std::vector<TableOneRow>& rows, std::string& page) {
  if (rows.empty()) return;
  page +=
      "\n## The scenes of the paper's Table 1\n\nOf its kinds and sizes, at 800 x 600, the "
      "airlight "
      "at every fourth pixel, the fewest slices that keep 2%. The paper's frames per second are "
      "those of a GPU of 2007. What the kernel reaches is the least time of the view pass's "
      "arithmetic, on data in registers, over the view pass's time, on one thread.\n\n"
      "| scene | frames per second | the paper's | setting | error | stages, ms | the kernel "
      "reaches |\n|---|---|---|---|---|---|---|\n";
  for (const TableOneRow& row : rows) {
    const Measurement& m = row.measurement;
    put(page, "| %s | %.1f (%.1f to %.1f) | %.0f | %s | %.2f%% |", row.name.c_str(),
        1e3 / m.milliseconds.median, 1e3 / m.milliseconds.greatest, 1e3 / m.milliseconds.least,
        row.paper_fps, m.setting.c_str(), 100.0 * m.error.rel_rmse);
    for (const StageTime& stage : m.stages) {
      if (stage.milliseconds >= 0.05) put(page, " %s %.1f", stage.name.c_str(), stage.milliseconds);
    }
    const Spread& reached = row.share.of_limit_with_pairs;
    put(page, " | %.0f%% (%.0f to %.0f) |\n", 100.0 * reached.median, 100.0 * reached.least,
        100.0 * reached.greatest);
  }
}

void put_savings(const std::vector<PlanSaving>& savings, std::string& page) {
  if (savings.empty()) return;
  page +=
      "\n## What a scene needs\n\nA stage that a scene does not need is left out. Beside it the "
      "same scene with as good as nothing for the stage to do (a billionth of a density, light or "
      "amplitude), so that it runs: CPU milliseconds of a frame of 200 x 150, and how far the "
      "pictures are apart.\n\n"
      "| stage | left out because | without | with | the picture changes by |\n"
      "|---|---|---|---|---|\n";
  for (const PlanSaving& saving : savings) {
    put(page, "| %s | %s | %.2f (%.2f to %.2f) | %.2f (%.2f to %.2f) | %.0g |\n",
        saving.stage.c_str(), saving.why.c_str(), saving.left_out.median, saving.left_out.least,
        saving.left_out.greatest, saving.made.median, saving.made.least, saving.made.greatest,
        saving.change);
  }
}

void put_hard_cases(const std::vector<HardCaseRow>& rows, std::string& page) {
  if (rows.empty()) return;
  const bool with_gl = rows[0].errors.gl.has_value();
  put(page,
      "\n## Hard cases\n\n%zu scenes that break careless arithmetic (resources/hard_cases), "
      "against what their pixels are, computed elsewhere to eleven digits: the relative RMSE of "
      "the airlight of the reference, in double, and of `sliced` with 24 slices, in float; the "
      "last "
      "number is that of `paper` in float against the same in double. A test holds them to these "
      "bounds: reference %g%%, paper %g%%, transmittance everywhere %g, `sliced` 1%% or what is "
      "stated.\n\n",
      rows.size(), 100.0 * hard_case_reference_bound, 100.0 * hard_case_paper_bound,
      hard_case_transmittance_bound);
  put(page, "| case | what breaks | what Brume does | reference | sliced |%s paper | bound |\n",
      with_gl ? " OpenGL |" : "");
  put(page, "|---|---|---|---|---|%s---|---|\n", with_gl ? "---|" : "");
  for (const auto& [hard_case, errors] : rows) {
    put(page, "| %s | %s | %s | %.0g | %.2f%% |", hard_case.name.c_str(), hard_case.breaks.c_str(),
        hard_case.remedy.c_str(), errors.reference.airlight, 100.0 * errors.sliced.airlight);
    if (errors.gl) put(page, " %.2f%% |", 100.0 * errors.gl->airlight);
    put(page, " %.0g | %g%%%s%s |\n", errors.paper, 100.0 * hard_case.bound,
        hard_case.why.empty() ? "" : ": ", hard_case.why.c_str());
  }
}

}  // namespace

std::string to_markdown(const BenchReport& report) {
  std::string page;
  put_head(report, page);
  put_fastest(report.scenes, page);
  put_errors(report.scenes, page);
  put_thickness(report.thickness, page);
  put_skies(report.skies, page);
  put_peers(report.scenes, page);
  put_gl(report, page);
  put_table_one(report.table_one, page);
  put_curves(report.curves, page);
  put_threads(report.thread_rows, page);
  put_savings(report.savings, page);
  put_hard_cases(report.hard_cases, page);
  return page;
}

}  // namespace brume
