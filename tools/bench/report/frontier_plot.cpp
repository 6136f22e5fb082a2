#include "tools/bench/report/frontier_plot.h"

#include <algorithm>
#include <cstdio>

#include "tools/bench/report/log_plot.h"

namespace brume {
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

std::string title(const std::string& name, double error, double milliseconds) {
  char value[96];
  std::snprintf(value, sizeof value, ": %.3f%%, %.1f ms", 100.0 * error, milliseconds);
  return name + value;
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
    plot.dot(100.0 * error, milliseconds, color, title(name, error, milliseconds));
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
