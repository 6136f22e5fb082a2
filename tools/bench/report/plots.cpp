#include "tools/bench/report/plots.h"

#include <algorithm>
#include <cmath>

#include "tools/bench/measure/report_text.h"

namespace brume {
namespace {

constexpr int height = 320;
constexpr int left = 64, right = 620, top = 12, bottom = 272;

LogPlot::Range decades(LogPlot::Range range) {
  const double low = std::floor(std::log10(std::max(range.first, 1e-9)));
  return {low, std::max(std::ceil(std::log10(std::max(range.second, 1e-9))), low + 1.0)};
}

double place(double value, LogPlot::Range axis) {
  const double fraction =
      (std::log10(std::max(value, 1e-9)) - axis.first) / (axis.second - axis.first);
  return std::clamp(fraction, 0.0, 1.0);
}

}  // namespace

LogPlot::LogPlot(Range x, Range y, const char* x_title, const char* y_title)
    : x_(decades(x)), y_(decades(y)) {
  for (double d = x_.first; d <= x_.second; ++d) {
    const double position = px(std::pow(10, d));
    put(svg_, "<path stroke=\"#ddd\" d=\"M%.1f %d V%d\"/>", position, top, bottom);
    put(svg_, "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g</text>\n", position, bottom + 14,
        std::pow(10, d));
  }
  for (double d = y_.first; d <= y_.second; ++d) {
    const double position = py(std::pow(10, d));
    put(svg_, "<path stroke=\"#ddd\" d=\"M%d %.1f H%d\"/>", left, position, right);
    put(svg_, "<text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%g</text>\n", left - 4, position + 4,
        std::pow(10, d));
  }
  put(svg_, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s</text>\n", (left + right) / 2,
      height - 8, x_title);
  put(svg_, "<text transform=\"translate(12 %d) rotate(-90)\" text-anchor=\"middle\">%s</text>\n",
      (top + bottom) / 2, y_title);
}

void LogPlot::dot(double x, double y, const char* color, const std::string& title) {
  put(svg_, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"><title>%s</title></circle>\n",
      px(x), py(y), color, escaped(title).c_str());
}

void LogPlot::legend(const std::vector<std::pair<std::string, std::string>>& names_and_colors) {
  width_ += 170;
  int y = top + 10;
  for (const auto& [name, color] : names_and_colors) {
    put(svg_,
        "<circle cx=\"%d\" cy=\"%d\" r=\"4\" fill=\"%s\"/><text x=\"%d\" y=\"%d\">%s</text>\n",
        right + 20, y - 4, color.c_str(), right + 30, y, escaped(name).c_str());
    y += 16;
  }
}

std::string LogPlot::svg() const {
  std::string text;
  put(text,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
      "font-family=\"sans-serif\" font-size=\"11\"><rect width=\"100%%\" height=\"100%%\" "
      "fill=\"#fff\"/>\n",
      width_, height, width_);
  return text + svg_ + "</svg>\n";
}

void LogPlot::line(const std::vector<std::pair<double, double>>& points, const char* color) {
  svg_ += "<path fill=\"none\" stroke=\"" + std::string(color) + "\" d=\"";
  for (std::size_t i = 0; i < points.size(); ++i) {
    put(svg_, "%c%.1f %.1f", i == 0 ? 'M' : 'L', px(points[i].first), py(points[i].second));
  }
  svg_ += "\"/>\n";
}

double LogPlot::px(double x) const {
  return left + place(x, x_) * (right - left);
}

double LogPlot::py(double y) const {
  return bottom - place(y, y_) * (bottom - top);
}

namespace {

constexpr const char* reference_color = "#555";
constexpr const char* gl_color = "#2ca02c";

// One after the other.
constexpr const char* peer_colors[] = {"#9467bd", "#8c564b", "#e377c2"};

const char* color_of(const Settings& settings) {
  switch (settings.airlight) {
    case AirlightMethod::paper:
      return "#c4a000";
    case AirlightMethod::auto_:
    case AirlightMethod::sliced:
      return settings.airlight_scale > 1 ? "#1f77b4" : "#6baed6";
    case AirlightMethod::reference:
    case AirlightMethod::path:
      return reference_color;
  }
  return "#000";
}

}  // namespace

std::string frontier_plot(const SceneReport& scene, bool with_legend) {
  double min_time = scene.settings[0].cpu_milliseconds.median;
  double max_time = scene.reference_cpu_milliseconds;
  double min_error = 1e-3;
  double max_error = 0.1;
  const auto include = [&](double milliseconds, double error) {
    min_time = std::min(min_time, milliseconds);
    max_time = std::max(max_time, milliseconds);
    min_error = std::min(min_error, std::max(error, 1e-5));
    max_error = std::max(max_error, error);
  };
  for (const auto* settings : {&scene.settings, &scene.on_gl}) {
    for (const Measurement& m : *settings) include(m.cpu_milliseconds.median, m.error.rel_rmse);
  }
  for (const OtherRendererRow& peer : scene.peers) include(peer.cpu_milliseconds, peer.rel_rmse);

  LogPlot plot({100.0 * min_error, 100.0 * max_error}, {min_time, max_time},
               "error: relative RMSE of the airlight [%]", "CPU time of a frame [ms]");
  std::vector<std::pair<std::string, std::string>> legend;
  const auto dot = [&](const std::string& name, double error, double milliseconds,
                       const char* color, const std::string& kind) {
    plot.dot(100.0 * error, milliseconds, color,
             name + formatted(": %.3f%%, %.1f ms", 100.0 * error, milliseconds));
    const std::pair<std::string, std::string> entry{kind, color};
    if (std::ranges::find(legend, entry) == legend.end()) legend.push_back(entry);
  };
  std::vector<std::pair<double, double>> best;
  for (const std::size_t i : frontier(scene.settings)) {
    const Measurement& m = scene.settings[i];
    best.emplace_back(100.0 * m.error.rel_rmse, m.cpu_milliseconds.median);
  }
  plot.line(best, "#333");
  for (const Measurement& m : scene.settings) {
    const std::string method = to_string(m.settings.airlight);
    dot(m.setting, m.error.rel_rmse, m.cpu_milliseconds.median, color_of(m.settings),
        m.settings.airlight_scale > 1 ? method + ", every fourth pixel" : method);
  }
  for (const Measurement& m : scene.on_gl) {
    dot("OpenGL, " + m.setting, m.error.rel_rmse, m.cpu_milliseconds.median, gl_color, "OpenGL");
  }
  std::vector<std::string> programs;
  for (const OtherRendererRow& peer : scene.peers) {
    auto it = std::ranges::find(programs, peer.program);
    if (it == programs.end()) it = programs.insert(it, peer.program);
    const char* const peer_color =
        peer_colors[static_cast<std::size_t>(it - programs.begin()) % std::size(peer_colors)];
    dot(peer.program + ", " + peer.setting, peer.rel_rmse, peer.cpu_milliseconds, peer_color,
        peer.program);
  }
  dot("reference", min_error, scene.reference_cpu_milliseconds, reference_color, "reference");
  if (with_legend) plot.legend(legend);
  return plot.svg();
}

}  // namespace brume
