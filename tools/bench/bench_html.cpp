#include "tools/bench/bench_html.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "tools/bench/bench_json.h"

namespace brume {
namespace {

// printf() to the end of a text.
[[gnu::format(printf, 2, 3)]] void put(std::string& to, const char* format, ...) {
  char text[1024];
  std::va_list arguments;
  va_start(arguments, format);
  const int size = std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  to.append(text, static_cast<std::size_t>(std::clamp(size, 0, 1023)));
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

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

// A plot with logarithmic axes over whole decades.
class LogPlot {
 public:
  LogPlot(std::pair<double, double> x, std::pair<double, double> y, const char* x_title,
          const char* y_title)
      : x_(decades(x)), y_(decades(y)) {
    put(svg_, "<svg viewBox=\"0 0 %d %d\" width=\"%d\">", width, height, width);
    for (double d = x_.first; d <= x_.second; ++d) {
      put(svg_, "<path class=grid d=\"M%.1f %d V%d\"/>", px(std::pow(10, d)), top, bottom);
      put(svg_, "<text x=\"%.1f\" y=\"%d\" class=mid>%g</text>", px(std::pow(10, d)), bottom + 14,
          std::pow(10, d));
    }
    for (double d = y_.first; d <= y_.second; ++d) {
      put(svg_, "<path class=grid d=\"M%d %.1f H%d\"/>", left, py(std::pow(10, d)), right);
      put(svg_, "<text x=\"%d\" y=\"%.1f\" class=end>%g</text>", left - 4, py(std::pow(10, d)) + 4,
          std::pow(10, d));
    }
    put(svg_, "<text x=\"%d\" y=\"%d\" class=mid>%s</text>", (left + right) / 2, height - 4,
        x_title);
    put(svg_, "<text transform=\"translate(12 %d) rotate(-90)\" class=mid>%s</text>",
        (top + bottom) / 2, y_title);
  }
  void dot(double x, double y, const char* color, const std::string& title) {
    put(svg_, "<circle cx=\"%.1f\" cy=\"%.1f\" r=4 fill=\"%s\"><title>%s</title></circle>", px(x),
        py(y), color, escaped(title).c_str());
  }
  void line(const std::vector<std::pair<double, double>>& points, const char* color) {
    svg_ += "<path fill=none stroke=\"" + std::string(color) + "\" d=\"";
    for (std::size_t i = 0; i < points.size(); ++i) {
      put(svg_, "%c%.1f %.1f", i == 0 ? 'M' : 'L', px(points[i].first), py(points[i].second));
    }
    svg_ += "\"/>";
  }
  [[nodiscard]] std::string svg() const { return svg_ + "</svg>\n"; }

 private:
  static constexpr int width = 560, height = 300;
  static constexpr int left = 60, right = 540, top = 12, bottom = 256;

  static std::pair<double, double> decades(std::pair<double, double> range) {
    const double low = std::floor(std::log10(std::max(range.first, 1e-9)));
    return {low, std::max(std::ceil(std::log10(std::max(range.second, 1e-9))), low + 1.0)};
  }
  static double place(double value, std::pair<double, double> axis) {
    return (std::log10(std::max(value, 1e-9)) - axis.first) / (axis.second - axis.first);
  }
  [[nodiscard]] double px(double x) const {
    return left + std::clamp(place(x, x_), 0.0, 1.0) * (right - left);
  }
  [[nodiscard]] double py(double y) const {
    return bottom - std::clamp(place(y, y_), 0.0, 1.0) * (bottom - top);
  }

  std::pair<double, double> x_, y_;
  std::string svg_;
};

const char* color_of(const Settings& settings) {
  switch (settings.airlight) {
    case AirlightMethod::paper:
      return "#c4a000";
    case AirlightMethod::sliced:
      return settings.airlight_scale > 1 ? "#1f77b4" : "#6baed6";
    case AirlightMethod::march:
      return settings.airlight_scale > 1 ? "#d62728" : "#f19c99";
    case AirlightMethod::reference:
      return "#555";
  }
  return "#000";
}

std::string frontier_plot(const SceneReport& scene) {
  double least_time = scene.settings[0].cpu_milliseconds.median;
  double greatest_time = scene.reference_cpu_milliseconds;
  double least_error = 1e-3;
  double greatest_error = 0.1;
  for (const Measurement& m : scene.settings) {
    least_time = std::min(least_time, m.cpu_milliseconds.median);
    greatest_time = std::max(greatest_time, m.cpu_milliseconds.median);
    least_error = std::min(least_error, std::max(m.error.rel_rmse, 1e-5));
    greatest_error = std::max(greatest_error, m.error.rel_rmse);
  }
  LogPlot plot({100.0 * least_error, 100.0 * greatest_error}, {least_time, greatest_time},
               "error, relative RMSE [%]", "CPU time of a frame [ms]");
  std::vector<std::pair<double, double>> best;
  for (const std::size_t i : frontier(scene.settings)) {
    const Measurement& m = scene.settings[i];
    best.emplace_back(100.0 * m.error.rel_rmse, m.cpu_milliseconds.median);
  }
  plot.line(best, "#333");
  for (const Measurement& m : scene.settings) {
    char value[96];
    std::snprintf(value, sizeof value, ": %.3f%%, %.1f ms", 100.0 * m.error.rel_rmse,
                  m.cpu_milliseconds.median);
    plot.dot(100.0 * m.error.rel_rmse, m.cpu_milliseconds.median, color_of(m.settings),
             m.setting + value);
  }
  plot.dot(100.0 * least_error, scene.reference_cpu_milliseconds, "#555", "reference");
  return plot.svg();
}

std::string picture_cell(const char* title, const std::string& png) {
  return std::string("<figure><img src=\"data:image/png;base64,") + base64(png) +
         "\"><figcaption>" + title + "</figcaption></figure>";
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
  html +=
      "</table>\n<details><summary>All settings</summary><table><tr><th>setting"
      "<th>frame [ms]<th>CPU [ms]<th>least, most<th>first frame [ms]<th>error<th>interval"
      "<th>stages [ms]";
  for (const Measurement& m : scene.settings) {
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
      "<th>setting<th>error<th>CPU [ms]<th>stages [ms]";
  for (const TableOneRow& row : rows) {
    const Measurement& m = row.measurement;
    put(html, "<tr><td>%s<td>%.1f<td>%.0f<td>%s<td>%.2f%%<td>%.1f<td>", row.name.c_str(),
        1e3 / m.milliseconds.median, row.paper_fps, m.setting.c_str(), 100.0 * m.error.rel_rmse,
        m.cpu_milliseconds.median);
    for (const StageTime& stage : m.stages) {
      if (stage.milliseconds < 0.05) continue;
      put(html, "%s %.1f ", stage.name.c_str(), stage.milliseconds);
    }
  }
  html += "</table>\n";
}

constexpr char style[] =
    "<style>body{font:14px sans-serif;max-width:1100px;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0}td,th{border:1px solid #ccc;padding:2px 8px;"
    "text-align:left}svg text{font-size:11px}.mid{text-anchor:middle}.end{text-anchor:end}"
    ".grid{stroke:#ddd}.row{display:flex;gap:1em}figure{margin:0 0 .5em}img{width:200px;"
    "image-rendering:pixelated}figcaption{font-size:11px}</style>\n";

}  // namespace

std::string to_html(const BenchReport& report, const std::string& command) {
  std::string html = "<!doctype html><meta charset=utf-8><title>Brume: speed against error</title>";
  html += style;
  html += "<h1>Speed against error</h1>\n";
  put(html, "<p><code>%s</code>: version %s, %s, %d threads. ", escaped(command).c_str(),
      BRUME_VERSION, escaped(device_name()).c_str(), report.threads);
  html +=
      "Times are medians of frames with the camera moving; CPU time is that of all threads "
      "together. The error is the relative RMSE of the airlight, measured against the "
      "converged integral at some pixels of the same frames. "
      "<b style=\"color:#c4a000\">paper</b>, <b style=\"color:#1f77b4\">sliced</b> and "
      "<b style=\"color:#d62728\">march</b>, pale at full resolution; the line is the "
      "frontier.</p>\n";
  for (const SceneReport& scene : report.scenes) put_scene(scene, html);
  if (!report.curves.empty()) put_curves(report.curves, html);
  if (!report.table_one.empty()) put_table_one(report.table_one, html);
  return html;
}

}  // namespace brume
