#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/bench/report/bench_report.h"

namespace brume {

// A plot as SVG, with logarithmic axes over whole decades.
class LogPlot {
 public:
  using Range = std::pair<double, double>;

  LogPlot(Range x, Range y, const char* x_title, const char* y_title);

  // `title` is shown where the mouse is.
  void dot(double x, double y, const char* color, const std::string& title);
  void line(const std::vector<std::pair<double, double>>& points, const char* color);

  // The meanings of the colours, to the right of the plot.
  void legend(const std::vector<std::pair<std::string, std::string>>& names_and_colors);

  [[nodiscard]] std::string svg() const;

 private:
  [[nodiscard]] double px(double x) const;
  [[nodiscard]] double py(double y) const;

  Range x_, y_;
  int width_ = 640;
  std::string svg_;
};

// The CPU time of a scene's settings, of the reference and of other programs against their error,
// as SVG. `with_legend`: what the colours mean is in it.
std::string frontier_plot(const SceneReport& scene, bool with_legend = false);

}  // namespace brume
