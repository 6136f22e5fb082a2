#include "tools/bench/report/error_tables.h"

#include <algorithm>

#include "tools/bench/measure/report_text.h"

namespace brume {
namespace {

// The second error has a column where there is a head for it.
void add_rows(const std::vector<ComparedError>& rows, ReportTable& table) {
  for (const ComparedError& row : rows) {
    auto& cells = table.rows.emplace_back();
    cells = {row.label, with_interval(row.error)};
    if (table.heads.size() > 2) cells.push_back(row.other ? with_interval(*row.other) : "");
  }
}

// "+1.2% (-0.3 to +2.5)": changes.
std::string with_signs(const Spread& change) {
  return formatted("%+.2g%% (%+.2g to %+.2g)", 100.0 * change.median, 100.0 * change.min,
                   100.0 * change.max);
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

ReportTable thickness_table(const std::vector<ThicknessRow>& rows) {
  ReportTable table{
      "Error over optical depth",
      "The sample scene dense_cloud with all densities scaled by a factor.",
      {"factor", "maximum optical depth", "`paper`", "`--paper-energy`", "`sliced` 24"},
      {},
      ""};
  for (const ThicknessRow& row : rows) {
    table.rows.push_back({formatted("%g", row.factor), formatted("%.2g", row.max_depth),
                          with_interval(row.paper), with_interval(row.energy),
                          with_interval(row.sliced)});
  }
  return table;
}

ReportTable sky_table(const std::vector<SkyRow>& rows) {
  ReportTable table{"Environment inscattering",
                    "The error of `sliced` 24 in clouds lit only by an environment: a uniform sky, "
                    "and a sky that is brighter towards the zenith and has a sun.",
                    {"Gaussians", "optical depth", "anisotropy", "uniform sky", "sky with a sun"},
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
                    "The worst case of the environment grid: small Gaussians in patches over a "
                    "landscape, the sample scene ground_fog, under a sun near the horizon.",
                    {"`sliced`", "error"},
                    {},
                    ""};
  add_rows(rows, table);
  return table;
}

ReportTable inscattering_table(const std::vector<InscatteringRow>& rows) {
  ReportTable table{"",
                    "The environment inscattering of `paper` (eq. 28) before a white sky, at the "
                    "centre of a Gaussian, as a share of exact single scattering.",
                    {"optical depth", "share"},
                    {},
                    ""};
  for (const InscatteringRow& row : rows) {
    table.rows.push_back({formatted("%g", row.depth), formatted("%.0f%%", 100.0 * row.share)});
  }
  return table;
}

ReportTable scale_table(const std::vector<ScaleRow>& rows) {
  ReportTable table{"Lower airlight resolution",
                    "`sliced` 24 at 800 x 600 with `--airlight-scale`: the share of pixels that "
                    "are computed rather than interpolated, and the relative RMSE of the airlight "
                    "against computing all of them.",
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

ReportTable all_orders_table(const std::vector<AllOrdersRow>& rows) {
  ReportTable table{
      "All orders of scattering",
      "`sliced` 24 at 48 x 36: the relative RMSE of the airlight against 512 paths per "
      "pixel, their noise taken out, of light scattered once and any number of times; "
      "the sweeps and the milliseconds to solve it from scratch, and once a Gaussian "
      "was moved; the time of a frame of 200 x 150 with a moved camera, all orders "
      "over one, as measured in turn; and the memory of the light on the grid.",
      {"scene", "once", "all orders", "noise", "sweeps", "solve", "edit", "moved camera", "MB"},
      {},
      ""};
  for (const AllOrdersRow& row : rows) {
    table.rows.push_back({row.scene, formatted("%.2g%%", 100.0 * row.single),
                          formatted("%.2g%%", 100.0 * row.multiple),
                          formatted("%.2g%%", 100.0 * row.noise), formatted("%d", row.sweeps),
                          formatted("%.0f", row.solve_milliseconds),
                          formatted("%.0f", row.edit_milliseconds),
                          with_spread(row.camera_ratio, 2), formatted("%.0f", row.megabytes)});
  }
  return table;
}

ReportTable light_kind_table(const std::vector<LightKindRow>& rows) {
  ReportTable table{"Kinds of lights and Gaussians",
                    "One light in a cloud of 300 Gaussians of depth 3, `sliced` 24 with light "
                    "scattered once: the relative RMSE of the airlight against the reference, and "
                    "times of frames of 400 x 300 over those with a point light in plain "
                    "Gaussians, measured in turn, "
                    "with a moved camera and with a moved light.",
                    {"light; medium", "error", "moved camera", "moved light"},
                    {},
                    ""};
  for (const LightKindRow& row : rows) {
    table.rows.push_back({row.kind, formatted("%.2g%%", 100.0 * row.error),
                          with_spread(row.camera_ratio, 2), with_spread(row.edit_ratio, 2)});
  }
  return table;
}

ReportTable sample_table(const std::vector<SampleRow>& rows) {
  ReportTable table{"Filtered pixels",
                    "Sample scenes at 320 x 240, `sliced` 24 with `--airlight-scale 4`: the "
                    "relative RMSE of the picture against 64 whole frames of shifted films, of one "
                    "sample a pixel and of the 16 that are chosen for pixels at edges; the share "
                    "of pixels that take them; and pairs of Gaussian and view ray, and times of "
                    "frames with a moved camera, over those of one sample.",
                    {"scene", "one", "16 at edges", "pixels", "pairs", "time"},
                    {},
                    ""};
  for (const SampleRow& row : rows) {
    table.rows.push_back({row.scene, formatted("%.2g%%", 100.0 * row.one),
                          formatted("%.2g%%", 100.0 * row.chosen),
                          formatted("%.1f%%", 100.0 * row.sampled), formatted("%.2f", row.pairs),
                          formatted("%.2f", row.time)});
  }
  return table;
}

ReportTable noise_depth_table(const std::vector<NoiseDepthRow>& rows) {
  ReportTable table{"Noise",
                    "The change that noise of amplitude 0.5 makes to the mean optical depth of a "
                    "picture of a cloud of 30 Gaussians: medians over eight seeds, with minimum "
                    "and maximum in parentheses.",
                    {"cells per u", "distant view", "close view"},
                    {},
                    ""};
  for (const NoiseDepthRow& row : rows) {
    table.rows.push_back({formatted("%g", row.cells), with_signs(row.afar), with_signs(row.near)});
  }
  return table;
}

ReportTable noise_table(const std::vector<ComparedError>& rows) {
  ReportTable table{"",
                    "The error of `sliced` 24 with noise, and for the same cloud without.",
                    {"cloud", "with noise", "without"},
                    {},
                    ""};
  add_rows(rows, table);
  return table;
}

ReportTable surface_light_table(const std::vector<ComparedError>& rows) {
  ReportTable table{
      "Light on surfaces",
      "Light reflected by surfaces, compared with unbiased Monte Carlo: relative RMSE over pixels "
      "or points, with the noise of the Monte Carlo estimate subtracted, and its 95% interval. "
      "First the light of a point light that fog scatters onto a ball, relative to the scattered "
      "light alone unless the row says all light. The light is inside homogeneous fog with an "
      "albedo of 60% for blue, or outside clouds of 30 random Gaussians of optical depth 3, behind "
      "more and more of the cloud. Beside it the paper's single point spread function.",
      {"receiver", "Brume", "`--paper-spread`"},
      {},
      ""};
  add_rows(rows, table);
  return table;
}

ReportTable incident_light_table(const std::vector<ComparedError>& rows) {
  ReportTable table{
      "",
      "Light of an environment, direct and scattered, on a white surface that casts no shadow: "
      "with the grid of `sliced` 24, and with the average optical depth (eq. 27) used by `paper`. "
      "The sky is uniform unless the row names a sun; the clouds have 30 Gaussians, and their "
      "depth is an optical depth.",
      {"receiver", "grid", "eq. 27"},
      {},
      ""};
  add_rows(rows, table);
  return table;
}

ReportTable transfer_table(const std::vector<ComparedError>& rows) {
  ReportTable table{"",
                    "Objects with and without radiance transfer. The last rows compare only the "
                    "light that is reflected once or twice before it reaches the eye.",
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
