// `sliced` against `march:N`, each with the fewest slices or steps that keep an error of 2%: CPU
// time of whole frames on one thread, the first with all that it builds and the next with the
// camera moved, when the tables of the lights are there. The same program, the same kernels, the
// same scene; the errors are measured against the reference and printed. Then `sliced` as auto and
// the editor take it, with the airlight at every fourth pixel, which `march` could have too.

#include <benchmark/benchmark.h>

#include <array>
#include <limits>
#include <stdexcept>

#include "render/quality/error_estimate.h"
#include "render/renderer.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

constexpr double error_held = 0.02;

struct Measured {
  Settings settings;
  double error = 0.0;
  // CPU time, the fastest of some.
  double first_seconds = std::numeric_limits<double>::infinity();
  double moved_seconds = std::numeric_limits<double>::infinity();
};

Frame first_frame(const Scene& scene, const Settings& settings) {
  return *Renderer().render(scene, scene.camera, scene.film, settings);
}

// The first of settings from cheap to costly that keeps the error.
template <class SettingsOf, std::size_t n>
Measured cheapest(const Scene& scene, const ErrorSample& sample, const std::array<int, n>& ladder,
                  SettingsOf settings_of) {
  for (const int rung : ladder) {
    const Settings settings = settings_of(rung);
    const double error = sample.measure(first_frame(scene, settings)).rel_rmse;
    if (error <= error_held) return {settings, error};
  }
  throw std::runtime_error("no setting keeps the error");
}

void time_frames(const Scene& scene, Measured& measured) {
  Renderer renderer;
  Camera camera = scene.camera;
  const auto seconds = [&] {
    const double begin = cpu_seconds();
    benchmark::DoNotOptimize(renderer.render(scene, camera, scene.film, measured.settings));
    return cpu_seconds() - begin;
  };
  measured.first_seconds = std::min(measured.first_seconds, seconds());
  camera.eye += 1e-6 * (camera.target - camera.eye);
  measured.moved_seconds = std::min(measured.moved_seconds, seconds());
}

// Time is that of a moved frame of `sliced`; first and moved are the ratios of CPU times, march
// over sliced; with _4, over sliced at every fourth pixel.
void sliced_against_march(benchmark::State& state, Scene (*make)()) {
  Scene scene = make();
  scene.film = {200, 150};
  Settings one_thread{.airlight = AirlightMethod::paper};
  one_thread.threads = 1;
  const auto sample =
      *ErrorSample::create(scene, scene.camera, first_frame(scene, one_thread), 300, 1, 1e-4);
  const auto sliced_at = [&](int scale) {
    return cheapest(scene, sample, std::array{4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 20, 24, 32, 48, 64},
                    [&](int slices) {
                      Settings settings = sliced_settings(one_thread, slices);
                      settings.airlight_scale = scale;
                      return settings;
                    });
  };
  Measured sliced = sliced_at(1);
  Measured sliced_4 = sliced_at(4);
  Measured march =
      cheapest(scene, sample,
               std::array{1,  2,  3,  4,  5,  6,  7,  8,  9,   10,  11,  12,  14,   16,   18,
                          20, 24, 28, 32, 40, 48, 64, 96, 128, 192, 256, 512, 1024, 2048, 4096},
               [&](int steps) {
                 Settings settings = one_thread;
                 settings.airlight = AirlightMethod::march;
                 settings.march_steps = steps;
                 return settings;
               });
  for (auto _ : state) {
    for (int i = 0; i < 5; ++i) {
      time_frames(scene, sliced);
      time_frames(scene, sliced_4);
      time_frames(scene, march);
    }
    state.SetIterationTime(sliced.moved_seconds);
  }
  state.counters["first"] = march.first_seconds / sliced.first_seconds;
  state.counters["moved"] = march.moved_seconds / sliced.moved_seconds;
  state.counters["first_4"] = march.first_seconds / sliced_4.first_seconds;
  state.counters["moved_4"] = march.moved_seconds / sliced_4.moved_seconds;
  state.counters["first_ms"] = 1e3 * sliced.first_seconds;
  state.counters["march_ms"] = 1e3 * march.moved_seconds;
  state.counters["steps"] = march.settings.march_steps;
  state.counters["march_error"] = march.error;
  state.counters["slices"] = sliced.settings.slices;
  state.counters["sliced_error"] = sliced.error;
  state.counters["slices_4"] = sliced_4.settings.slices;
  state.counters["error_4"] = sliced_4.error;
}

Scene bunny_fog() {
  return sample_airlight("bunny_fog");
}
Scene box_3008() {
  return sample_airlight("box_3008");
}
Scene dense_cloud() {
  return sample_airlight("dense_cloud");
}

void register_scene(const char* name, Scene (*make)()) {
  benchmark::RegisterBenchmark(name, sliced_against_march, make)
      ->UseManualTime()
      ->Iterations(1)
      ->Repetitions(3)
      ->ReportAggregatesOnly()
      ->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = [] {
  register_scene("sliced_against_march/2_gaussians", two_gaussians);
  register_scene("sliced_against_march/34_gaussians_3_lights", bunny_fog);
  register_scene("sliced_against_march/300_gaussians_dense_2_lights", dense_cloud);
  register_scene("sliced_against_march/3008_gaussians", box_3008);
  return true;
}();

}  // namespace
}  // namespace brume
