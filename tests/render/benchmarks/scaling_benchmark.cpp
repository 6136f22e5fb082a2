// How the CPU time of a whole frame of `sliced` grows: with Gaussians at constant optical depth and
// error, and with lights, all that a first frame builds included; with pixels and with slices,
// where a camera move has left the tables of the lights alone. `exponent` is fitted over all sizes:
// time ~ size^exponent, and the error of each size.

#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "render/quality/auto_quality.h"
#include "render/renderer.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

struct Point {
  double size, seconds;
};

// The slope of log(seconds) over log(size), by least squares.
double exponent(const std::vector<Point>& points) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Point& p : points) {
    const double log_size = std::log(p.size);
    const double log_time = std::log(p.seconds);
    n += 1.0;
    x += log_size;
    y += log_time;
    xx += log_size * log_size;
    xy += log_size * log_time;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

struct Case {
  Scene scene;
  Settings settings;
  bool is_first = true;  // or a frame after a camera move
};

// The fastest of some frames, and the frame's error.
void measure(benchmark::State& state, const Case& of, int size, std::vector<Point>& points) {
  double seconds = std::numeric_limits<double>::infinity();
  Frame frame;
  for (int i = 0; i < 3; ++i) {
    Renderer renderer;
    Camera camera = of.scene.camera;
    camera.eye.x += 1e-6;
    if (!of.is_first)
      static_cast<void>(renderer.render(of.scene, camera, of.scene.film, of.settings));
    const double begin = cpu_seconds();
    frame = *renderer.render(of.scene, of.scene.camera, of.scene.film, of.settings);
    seconds = std::min(seconds, cpu_seconds() - begin);
  }
  points.push_back({static_cast<double>(size), seconds});
  const std::string name = std::to_string(size);
  state.counters["ms_" + name] = 1e3 * seconds;
  state.counters["error_" + name] = measure_error(of.scene, of.scene.camera, frame)->rel_rmse;
}

void growth(benchmark::State& state, const std::vector<int>& sizes, Case (*make)(int)) {
  std::vector<Point> points;
  for (auto _ : state) {
    for (const int size : sizes) measure(state, make(size), size, points);
    state.SetIterationTime(points.back().seconds);
  }
  state.counters["exponent"] = exponent(points);
}

Case gaussians(int count) {
  Scene scene = box_scene(count, 1);
  Renderer renderer;
  const Settings settings =
      *choose_settings(renderer, scene, scene.camera, scene.film, {.max_error = 0.03});
  return {std::move(scene), settings};
}
Case lights(int count) {
  return {box_scene(1000, count), sliced_settings({}, 16)};
}
Case pixels(int thousands) {
  Case result{box_scene(1000, 1), sliced_settings({}, 16), false};
  const double scale = std::sqrt(thousands / 12.0);
  result.scene.film = {static_cast<int>(std::lround(128 * scale)),
                       static_cast<int>(std::lround(96 * scale))};
  return result;
}
Case slices(int count) {
  // One size of table for all: what is varied is the slices.
  Settings settings = sliced_settings({}, 64);
  settings.slices = count;
  return {box_scene(1000, 1), settings, false};
}

void register_growth(const char* name, const std::vector<int>& sizes, Case (*make)(int)) {
  benchmark::RegisterBenchmark(name, growth, sizes, make)
      ->UseManualTime()
      ->Iterations(1)
      ->Repetitions(3)
      ->ReportAggregatesOnly()
      ->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = [] {
  register_growth("growth_with/gaussians", {1000, 4000, 16000, 64000}, gaussians);
  register_growth("growth_with/lights", {1, 2, 4, 8}, lights);
  register_growth("growth_with/kilopixels", {12, 48, 192, 768}, pixels);
  register_growth("growth_with/slices", {8, 16, 32, 64, 128}, slices);
  return true;
}();

}  // namespace
}  // namespace brume
