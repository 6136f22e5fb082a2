#pragma once

#include <string>

#include "tools/bench/measure/report_text.h"
#include "tools/bench/report/bench_report.h"

namespace brume {

// A value of the rows of a section, described once: its key in the JSON, its head in the table, and
// how a cell shows it.
template <class Row, class T>
struct ReportColumn {
  const char* key;
  const char* head;
  T Row::*value;
  std::string (*cell)(const T&);
};

template <class Row, class T>
ReportColumn<Row, T> column(const char* key, const char* head, T Row::*value,
                            std::string (*cell)(const T&)) {
  return {key, head, value, cell};
}

namespace report_cell {

inline std::string as_is(const std::string& text) {
  return text;
}
inline std::string plain(const double& x) {
  return formatted("%g", x);
}
inline std::string two_digits(const double& x) {
  return formatted("%.2g", x);
}
inline std::string two_decimals(const double& x) {
  return formatted("%.2f", x);
}
template <class Number>
std::string whole(const Number& x) {
  return formatted("%.0f", static_cast<double>(x));
}
template <int decimals>
std::string percent(const double& x) {
  return formatted("%.*f%%", decimals, 100.0 * x);
}
inline std::string error_percent(const double& x) {
  return formatted("%.2g%%", 100.0 * x);
}
inline std::string ratio(const Spread& spread) {
  return with_spread(spread, 2);
}
inline std::string if_any(const std::optional<ErrorEstimate>& error) {
  return error ? with_interval(*error) : "";
}
// "+1.2% (-0.3 to +2.5)": changes.
inline std::string with_signs(const Spread& change) {
  return formatted("%+.2g%% (%+.2g to %+.2g)", 100.0 * change.median, 100.0 * change.min,
                   100.0 * change.max);
}

}  // namespace report_cell

// Each calls visit(key in the JSON, rows, title, lead, columns ...) for some sections about errors.

void visit_airlight_sections(const BenchReport& report, auto&& visit) {
  using namespace report_cell;
  visit("thickness", report.thickness, "Error over optical depth",
        "The sample scene dense_cloud with all densities scaled by a factor.",
        column("factor", "factor", &ThicknessRow::factor, plain),
        column("max_depth", "maximum optical depth", &ThicknessRow::max_depth, two_digits),
        column("paper", "`paper`", &ThicknessRow::paper, with_interval),
        column("energy", "`--paper-energy`", &ThicknessRow::energy, with_interval),
        column("sliced", "`sliced` 24", &ThicknessRow::sliced, with_interval));
  visit("skies", report.skies, "Environment inscattering",
        "The error of `sliced` 24 in clouds lit only by an environment: a uniform sky, "
        "and a sky that is brighter towards the zenith and has a sun.",
        column("gaussians", "Gaussians", &SkyRow::gaussians, whole),
        column("depth", "optical depth", &SkyRow::depth, plain),
        column("anisotropy", "anisotropy", &SkyRow::anisotropy, plain),
        column("even", "uniform sky", &SkyRow::even, with_interval),
        column("sunny", "sky with a sun", &SkyRow::sunny, with_interval));
  visit("patches", report.patches, "",
        "The worst case of the environment grid: small Gaussians in patches over a "
        "landscape, the sample scene ground_fog, under a sun near the horizon.",
        column("what", "`sliced`", &ComparedError::label, as_is),
        column("error", "error", &ComparedError::error, with_interval));
  visit("glow", report.glow, "",
        "The environment inscattering of `paper` (eq. 28) before a white sky, at the "
        "centre of a Gaussian, as a share of exact single scattering.",
        column("depth", "optical depth", &InscatteringRow::depth, plain),
        column("share", "share", &InscatteringRow::share, percent<0>));
  visit("airlight_scale", report.scales, "Lower airlight resolution",
        "`sliced` 24 at 800 x 600 with `--airlight-scale`: the share of pixels that "
        "are computed rather than interpolated, and the relative RMSE of the airlight "
        "against computing all of them.",
        column("name", "scene", &ScaleRow::scene, as_is),
        column("scale", "scale", &ScaleRow::scale, whole),
        column("computed", "computed", &ScaleRow::computed, percent<1>),
        column("change", "change", &ScaleRow::change, error_percent));
}

void visit_scattering_sections(const BenchReport& report, auto&& visit) {
  using namespace report_cell;
  visit("all_orders", report.all_orders, "All orders of scattering",
        "`sliced` 24 at 48 x 36: the relative RMSE of the airlight against 512 paths per "
        "pixel, their noise taken out, of light scattered once and any number of times; "
        "the sweeps and the milliseconds to solve it from scratch, and once a Gaussian "
        "was moved; the time of a frame of 200 x 150 with a moved camera, all orders "
        "over one, as measured in turn; and the memory of the light on the grid.",
        column("name", "scene", &AllOrdersRow::scene, as_is),
        column("single", "once", &AllOrdersRow::single, error_percent),
        column("multiple", "all orders", &AllOrdersRow::multiple, error_percent),
        column("noise", "noise", &AllOrdersRow::noise, error_percent),
        column("sweeps", "sweeps", &AllOrdersRow::sweeps, whole),
        column("solve_ms", "solve", &AllOrdersRow::solve_milliseconds, whole),
        column("edit_ms", "edit", &AllOrdersRow::edit_milliseconds, whole),
        column("camera_ratio", "moved camera", &AllOrdersRow::camera_ratio, ratio),
        column("megabytes", "MB", &AllOrdersRow::megabytes, whole));
  visit("light_kinds", report.light_kinds, "Kinds of lights and Gaussians",
        "One light in a cloud of 300 Gaussians of depth 3, `sliced` 24 with light "
        "scattered once: the relative RMSE of the airlight against the reference, and "
        "times of frames of 400 x 300 over those with a point light in plain "
        "Gaussians, measured in turn, "
        "with a moved camera and with a moved light.",
        column("name", "light; medium", &LightKindRow::kind, as_is),
        column("error", "error", &LightKindRow::error, error_percent),
        column("camera_ratio", "moved camera", &LightKindRow::camera_ratio, ratio),
        column("edit_ratio", "moved light", &LightKindRow::edit_ratio, ratio));
  visit("samples", report.samples, "Filtered pixels",
        "Sample scenes at 320 x 240, `sliced` 24 with `--airlight-scale 4`: the "
        "relative RMSE of the picture against 64 whole frames of shifted films, of one "
        "sample a pixel and of the 16 that are chosen for pixels at edges; the share "
        "of pixels that take them; and pairs of Gaussian and view ray, and times of "
        "frames with a moved camera, over those of one sample.",
        column("name", "scene", &SampleRow::scene, as_is),
        column("one", "one", &SampleRow::one, error_percent),
        column("chosen", "16 at edges", &SampleRow::chosen, error_percent),
        column("sampled", "pixels", &SampleRow::sampled, percent<1>),
        column("pairs_ratio", "pairs", &SampleRow::pairs, two_decimals),
        column("camera_ratio", "time", &SampleRow::time, two_decimals));
}

void visit_noise_and_surface_sections(const BenchReport& report, auto&& visit) {
  using namespace report_cell;
  visit("noise_depths", report.noise_depths, "Noise",
        "The change that noise of amplitude 0.5 makes to the mean optical depth of a "
        "picture of a cloud of 30 Gaussians: medians over eight seeds, with minimum "
        "and maximum in parentheses.",
        column("cells", "cells per u", &NoiseDepthRow::cells, plain),
        column("afar", "distant view", &NoiseDepthRow::afar, with_signs),
        column("near", "close view", &NoiseDepthRow::near, with_signs));
  visit("noise", report.noise, "",
        "The error of `sliced` 24 with noise, and for the same cloud without.",
        column("what", "cloud", &ComparedError::label, as_is),
        column("error", "with noise", &ComparedError::error, with_interval),
        column("other", "without", &ComparedError::other, if_any));
  visit(
      "lamp_light", report.point_light, "Light on surfaces",
      "Light reflected by surfaces, compared with unbiased Monte Carlo: relative RMSE over pixels "
      "or points, with the noise of the Monte Carlo estimate subtracted, and its 95% interval. "
      "First the light of a point light that fog scatters onto a ball, relative to the scattered "
      "light alone unless the row says all light. The light is inside homogeneous fog with an "
      "albedo of 60% for blue, or outside clouds of 30 random Gaussians of optical depth 3, behind "
      "more and more of the cloud. Beside it the paper's single point spread function.",
      column("what", "receiver", &ComparedError::label, as_is),
      column("error", "Brume", &ComparedError::error, with_interval),
      column("other", "`--paper-spread`", &ComparedError::other, if_any));
  visit(
      "arriving_light", report.incident_light, "",
      "Light of an environment, direct and scattered, on a white surface that casts no shadow: "
      "with the grid of `sliced` 24, and with the average optical depth (eq. 27) used by `paper`. "
      "The sky is uniform unless the row names a sun; the clouds have 30 Gaussians, and their "
      "depth is an optical depth.",
      column("what", "receiver", &ComparedError::label, as_is),
      column("error", "grid", &ComparedError::error, with_interval),
      column("other", "eq. 27", &ComparedError::other, if_any));
  visit("transfer", report.transfer, "",
        "Objects with and without radiance transfer. The last rows compare only the "
        "light that is reflected once or twice before it reaches the eye.",
        column("what", "object", &ComparedError::label, as_is),
        column("error", "with transfer", &ComparedError::error, with_interval),
        column("other", "without", &ComparedError::other, if_any));
}

// All of them, in the order of the report.
void visit_error_sections(const BenchReport& report, auto&& visit) {
  visit_airlight_sections(report, visit);
  visit_scattering_sections(report, visit);
  visit_noise_and_surface_sections(report, visit);
}

}  // namespace brume
