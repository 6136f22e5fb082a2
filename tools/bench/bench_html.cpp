#include "tools/bench/bench_html.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "tools/bench/device_name.h"
#include "tools/bench/frontier_plot.h"
#include "tools/bench/log_plot.h"

namespace brume {
namespace {

std::string base64(const std::string& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

std::string picture_cell(const char* title, const std::string& png) {
  return std::string("<figure><img src=\"data:image/png;base64,") + base64(png) +
         "\"><figcaption>" + title + "</figcaption></figure>";
}

void put_peers(const SceneReport& scene, std::string& html) {
  if (scene.peers.empty()) return;
  html += "<table><tr><th>program<th>setting<th>CPU time<th>error";
  for (const PeerRow& peer : scene.peers) {
    put(html, "<tr><td>%s<td>%s<td>%.1f s<td>%.2f%%", escaped(peer.program).c_str(),
        escaped(peer.setting).c_str(), 1e-3 * peer.cpu_milliseconds, 100.0 * peer.rel_rmse);
  }
  html += "</table>\n";
}

void put_scene(const SceneReport& scene, std::string& html) {
  put(html, "<h2>%s</h2>\n<p>%zu Gaussians, %zu lamps%s, %d x %d pixels. ",
      escaped(scene.name).c_str(), scene.gaussians, scene.lights,
      scene.environment ? ", an environment" : "", scene.film.width, scene.film.height);
  put(html, "The reference takes %.1f s of CPU time for a whole frame.</p>\n<div class=row>",
      1e-3 * scene.reference_cpu_milliseconds);
  html += frontier_plot(scene);
  html += "<div>";
  html += picture_cell(escaped(scene.picture.setting).c_str(), scene.picture.frame);
  html += picture_cell("reference", scene.picture.reference);
  char white[64];
  std::snprintf(white, sizeof white, "error; white: %.0f%% of the mean",
                100.0 * scene.picture.error_scale);
  html += picture_cell(white, scene.picture.error);
  html += "</div></div>\n<table><tr><th>error at most<th>fastest<th>CPU time";
  for (const double level : bench_error_levels) {
    const auto best = cheapest_within(scene.settings, level);
    put(html, "<tr><td>%g%%", 100.0 * level);
    if (!best) {
      html += "<td>none<td>";
      continue;
    }
    const Measurement& m = scene.settings[*best];
    put(html, "<td>%s<td>%.1f ms", m.setting.c_str(), m.cpu_milliseconds.median);
  }
  html += "</table>\n";
  put_peers(scene, html);
  html +=
      "<details><summary>All settings</summary><table><tr><th>setting"
      "<th>frame [ms]<th>CPU [ms]<th>least, most<th>first frame [ms]<th>error<th>interval"
      "<th>stages [ms]";
  std::vector<Measurement> all = scene.settings;
  for (Measurement m : scene.on_gl) {
    m.setting = "OpenGL, " + m.setting;
    all.push_back(m);
  }
  for (const Measurement& m : all) {
    put(html, "<tr><td>%s<td>%.2f<td>%.2f<td>%.2f, %.2f<td>%.1f<td>%.3f%%<td>%.3f, %.3f%%<td>",
        m.setting.c_str(), m.milliseconds.median, m.cpu_milliseconds.median,
        m.cpu_milliseconds.least, m.cpu_milliseconds.greatest, m.first_milliseconds,
        100.0 * m.error.rel_rmse, 100.0 * m.error.low, 100.0 * m.error.high);
    for (const StageTime& stage : m.stages) {
      if (stage.milliseconds < 0.05) continue;
      put(html, "%s %.1f ", stage.name.c_str(), stage.milliseconds);
    }
  }
  html += "</table></details>\n";
}

void put_curves(const std::vector<CostCurve>& curves, std::string& html) {
  html +=
      "<h2>Cost</h2>\n<p>CPU time of a frame of 1,000 Gaussians of constant depth, one lamp, "
      "200 x 150 pixels, sliced 24, where one thing grows.</p>\n";
  for (const CostCurve& curve : curves) {
    const auto [least, most] = std::ranges::minmax(curve.points, {}, &CostPoint::cpu_milliseconds);
    LogPlot plot({curve.points.front().size, curve.points.back().size},
                 {least.cpu_milliseconds, most.cpu_milliseconds}, curve.over.c_str(),
                 "CPU time of a frame [ms]");
    std::vector<std::pair<double, double>> line;
    for (const CostPoint& p : curve.points) {
      line.emplace_back(p.size, p.cpu_milliseconds);
      char value[64];
      std::snprintf(value, sizeof value, "%g: %.1f ms", p.size, p.cpu_milliseconds);
      plot.dot(p.size, p.cpu_milliseconds, "#1f77b4", value);
    }
    plot.line(line, "#1f77b4");
    put(html, "<h3>%s</h3><p>CPU time grows like their number to the power of %.2f.</p>\n",
        curve.over.c_str(), curve.exponent);
    html += plot.svg();
  }
}

void put_table_one(const std::vector<TableOneRow>& rows, std::string& html) {
  html +=
      "<h2>Table 1 of the paper</h2>\n<p>800 x 600, the airlight at every fourth pixel, the "
      "fewest slices that keep an error of 2%, the camera moving. The paper's figures are "
      "those of a GPU of 2007.</p>\n<table><tr><th>scene<th>frames per second<th>the paper"
      "<th>setting<th>error<th>CPU [ms]<th>share of the kernel's limit<th>stages [ms]";
  for (const TableOneRow& row : rows) {
    const Measurement& m = row.measurement;
    put(html, "<tr><td>%s<td>%.1f<td>%.0f<td>%s<td>%.2f%%<td>%.1f<td>%.0f%%<td>", row.name.c_str(),
        1e3 / m.milliseconds.median, row.paper_fps, m.setting.c_str(), 100.0 * m.error.rel_rmse,
        m.cpu_milliseconds.median, 100.0 * row.share.of_limit_with_pairs.median);
    for (const StageTime& stage : m.stages) {
      if (stage.milliseconds < 0.05) continue;
      put(html, "%s %.1f ", stage.name.c_str(), stage.milliseconds);
    }
  }
  html += "</table>\n";
}

void put_threads(const std::vector<ThreadRow>& rows, std::string& html) {
  html +=
      "<h2>Threads</h2>\n<p>The box of 1,000 Gaussians at 800 x 600, sliced 24.</p>\n<table><tr>"
      "<th>threads<th>frame [ms]<th>least, most<th>times as fast as one";
  for (const ThreadRow& row : rows) {
    put(html, "<tr><td>%d<td>%.1f<td>%.1f, %.1f<td>%.2f", row.threads, row.milliseconds.median,
        row.milliseconds.least, row.milliseconds.greatest,
        rows[0].milliseconds.median / row.milliseconds.median);
  }
  html += "</table>\n";
}

void put_savings(const std::vector<PlanSaving>& savings, std::string& html) {
  html +=
      "<h2>What a scene needs</h2>\n<p>CPU time of a frame of 200 x 150 where a stage is left "
      "out, and of the same picture where it has as good as nothing to do.</p>\n<table><tr>"
      "<th>stage<th>left out because<th>without [ms]<th>with [ms]<th>the picture changes by";
  for (const PlanSaving& saving : savings) {
    put(html, "<tr><td>%s<td>%s<td>%.2f<td>%.2f<td>%.1e", saving.stage.c_str(), saving.why.c_str(),
        saving.left_out.median, saving.made.median, saving.change);
  }
  html += "</table>\n";
}

void put_hard_cases(const std::vector<HardCaseRow>& rows, std::string& html) {
  const bool with_gl = rows[0].errors.gl.has_value();
  html +=
      "<h2>Hard cases</h2>\n<p>Relative RMSE of the airlight against values computed elsewhere "
      "to eleven digits: of the reference in double, of sliced 24 in float; of paper in float "
      "against the same in double.</p>\n<table><tr><th>case<th>what breaks<th>what Brume does"
      "<th>reference<th>sliced 24";
  if (with_gl) html += "<th>OpenGL";
  html += "<th>paper<th>bound of sliced";
  for (const auto& [hard_case, errors] : rows) {
    put(html, "<tr><td>%s<td>%s<td>%s<td>%.1e<td>%.2f%%", hard_case.name.c_str(),
        escaped(hard_case.breaks).c_str(), escaped(hard_case.remedy).c_str(),
        errors.reference.airlight, 100.0 * errors.sliced.airlight);
    if (errors.gl) put(html, "<td>%.2f%%", 100.0 * errors.gl->airlight);
    put(html, "<td>%.1e<td>%g%% %s", errors.paper, 100.0 * hard_case.bound,
        escaped(hard_case.why).c_str());
  }
  html += "</table>\n";
}

constexpr char style[] =
    "<style>body{font:14px sans-serif;max-width:1100px;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0}td,th{border:1px solid #ccc;padding:2px 8px;"
    "text-align:left}.row{display:flex;gap:1em}figure{margin:0 0 .5em}img{width:200px;"
    "image-rendering:pixelated}figcaption{font-size:11px}</style>\n";

}  // namespace

std::string to_html(const BenchReport& report) {
  std::string html = "<!doctype html><meta charset=utf-8><title>Brume: speed against error</title>";
  html += style;
  html += "<h1>Speed against error</h1>\n";
  put(html, "<p><code>%s</code>: version %s, %s, %d threads. ", escaped(report.command).c_str(),
      BRUME_VERSION, escaped(device_name()).c_str(), report.threads);
  html +=
      "Times are medians of frames with the camera moving; CPU time is that of all threads "
      "together. The error is the relative RMSE of the airlight, measured against the "
      "converged integral at some pixels of the same frames. "
      "<b style=\"color:#c4a000\">paper</b>, <b style=\"color:#1f77b4\">sliced</b> and "
      "<b style=\"color:#d62728\">march</b>, pale at full resolution, "
      "other programs in other colours; the line is the frontier.</p>\n";
  for (const SceneReport& scene : report.scenes) put_scene(scene, html);
  if (!report.curves.empty()) put_curves(report.curves, html);
  if (!report.thread_rows.empty()) put_threads(report.thread_rows, html);
  if (!report.savings.empty()) put_savings(report.savings, html);
  if (!report.hard_cases.empty()) put_hard_cases(report.hard_cases, html);
  if (!report.table_one.empty()) put_table_one(report.table_one, html);
  return html;
}

}  // namespace brume
