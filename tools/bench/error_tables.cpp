#include "tools/bench/error_tables.h"

#include <algorithm>

#include "tools/bench/report_text.h"

namespace brume {
namespace {

// The second error has a column where there is a head for it.
void add_rows(const std::vector<ComparedError>& rows, ReportTable& table) {
  for (const ComparedError& row : rows) {
    auto& cells = table.rows.emplace_back();
    cells = {row.what, with_interval(row.error)};
    if (table.heads.size() > 2) cells.push_back(row.other ? with_interval(*row.other) : "");
  }
}

// "+1.2% (-0.3 to +2.5)": changes.
std::string with_signs(const Spread& change) {
  return formatted("%+.2g%% (%+.2g to %+.2g)", 100.0 * change.median, 100.0 * change.least,
                   100.0 * change.greatest);
}

}  // namespace

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
  ReportTable table{
      "Thin and thick fog",
      "The sample scene dense_cloud, all densities times a factor.",
      {"factor", "greatest optical depth", "`paper`", "`--paper-energy`", "`sliced` 24"},
      {},
      ""};
  for (const ThicknessRow& row : rows) {
    table.rows.push_back({formatted("%g", row.factor), formatted("%.2g", row.greatest_depth),
                          with_interval(row.paper), with_interval(row.energy),
                          with_interval(row.sliced)});
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

ReportTable patch_table(const std::vector<ComparedError>& rows) {
  ReportTable table{"",
                    "Where the grid of that light is at its worst: small Gaussians in patches over "
                    "a landscape, the sample scene ground_fog, under a sun near the horizon.",
                    {"`sliced`", "error"},
                    {},
                    ""};
  add_rows(rows, table);
  return table;
}

ReportTable glow_table(const std::vector<GlowRow>& rows) {
  ReportTable table{"",
                    "The glow of `paper` (eq. 28) before a white sky, in the middle of a Gaussian, "
                    "over the light that single scattering gives there.",
                    {"optical depth", "share"},
                    {},
                    ""};
  for (const GlowRow& row : rows) {
    table.rows.push_back({formatted("%g", row.depth), formatted("%.0f%%", 100.0 * row.share)});
  }
  return table;
}

ReportTable scale_table(const std::vector<ScaleRow>& rows) {
  ReportTable table{"Fewer pixels",
                    "`sliced` 24 at 800 x 600 with `--airlight-scale`: the share of the pixels "
                    "that is computed, and the relative RMSE of the airlight against all of them.",
                    {"scene", "scale", "computed", "change"},
                    {},
                    ""};
  for (const ScaleRow& row : rows) {
    table.rows.push_back({row.scene, formatted("%d", row.scale),
                          formatted("%.1f%%", 100.0 * row.computed),
                          formatted("%.2g%%", 100.0 * row.change)});
  }
  return table;
}

ReportTable noise_depth_table(const std::vector<NoiseDepthRow>& rows) {
  ReportTable table{"Noise",
                    "How the optical depth, averaged over a picture of a cloud of 30 Gaussians, "
                    "changes by noise of the amplitude 0.5: medians over eight seeds, least and "
                    "greatest in parentheses.",
                    {"cells per u", "from afar", "from near"},
                    {},
                    ""};
  for (const NoiseDepthRow& row : rows) {
    table.rows.push_back({formatted("%g", row.cells), with_signs(row.afar), with_signs(row.near)});
  }
  return table;
}

ReportTable noise_table(const std::vector<ComparedError>& rows) {
  ReportTable table{"",
                    "The error of `sliced` 24 in noise, and in the same cloud without it.",
                    {"cloud", "with noise", "without"},
                    {},
                    ""};
  add_rows(rows, table);
  return table;
}

ReportTable lamp_light_table(const std::vector<ComparedError>& rows) {
  ReportTable table{
      "Light on surfaces",
      "What surfaces reflect, held against unbiased Monte Carlo: relative RMSE over pixels or "
      "places, the noise of the Monte Carlo taken out, and its 95% interval. First the light of a "
      "lamp that fog scatters onto a ball, relative to what is scattered unless all light is "
      "named: in even fog, which scatters 60% of the blue light, with the lamp in it; and in "
      "clouds of 30 random Gaussians 3 deep, the lamp outside behind more and more of it. Beside "
      "it the paper's one point spread function.",
      {"receiver", "here", "`--paper-spread`"},
      {},
      ""};
  add_rows(rows, table);
  return table;
}

ReportTable arriving_light_table(const std::vector<ComparedError>& rows) {
  ReportTable table{
      "",
      "The light of an environment, straight and scattered, on a white surface that casts no "
      "shadow: by the grid of `sliced` 24, and by the average optical depth (eq. 27) as `paper` "
      "takes it. An even sky but where a sun is named, clouds of 30 Gaussians.",
      {"receiver", "grid", "eq. 27"},
      {},
      ""};
  add_rows(rows, table);
  return table;
}

ReportTable transfer_table(const std::vector<ComparedError>& rows) {
  ReportTable table{"",
                    "Objects with radiance transfer and without. The last rows are of the light "
                    "alone that is reflected once or twice before it is seen.",
                    {"object", "with transfer", "without"},
                    {},
                    ""};
  add_rows(rows, table);
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
          "that of `paper` in float against the same in double. `auto` is to keep %g%%; told: it "
          "says "
          "that its error may be larger, by the upper end of what it measured. A test holds all to "
          "these bounds: reference %g%%, paper %g%%, transmittance everywhere %g, `sliced` 1%% or "
          "what is stated, `auto` within its own or told.",
          rows.size(), 100.0 * hard_case_max_error, 100.0 * hard_case_reference_bound,
          100.0 * hard_case_paper_bound, hard_case_transmittance_bound),
      {"case", "what breaks", "what Brume does", "reference", "sliced"},
      {},
      ""};
  if (with_gl) table.heads.emplace_back("OpenGL");
  table.heads.insert(table.heads.end(), {"auto", "paper", "bound of sliced"});
  for (const auto& [hard_case, errors] : rows) {
    std::vector<std::string> row = {hard_case.name, hard_case.breaks, hard_case.remedy,
                                    formatted("%.0g", errors.reference.airlight),
                                    formatted("%.2f%%", 100.0 * errors.sliced.airlight)};
    if (errors.gl) row.push_back(formatted("%.2f%%", 100.0 * errors.gl->airlight));
    row.push_back(formatted("%.2f%%", 100.0 * errors.automatic.airlight) +
                  (errors.automatic.is_told ? ", told" : ""));
    row.push_back(formatted("%.0g", errors.paper));
    row.push_back(formatted("%g%%", 100.0 * hard_case.bound) +
                  (hard_case.why.empty() ? "" : ": " + hard_case.why));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace brume
