// Frames of 800 x 600 with the camera moving, airlight at every fourth pixel, everything that a
// camera does not change built before: the measurement of Table 1 of the paper, on scenes of its
// kinds, with the fewest slices that keep an error of 2%. The paper's frames per second (on a GPU
// of 2007) are listed next to ours. cpu_share is the CPU time over the time of all cores: far below
// 1 means that others used the machine too, and that frames per second say little; fps_alone is
// what the CPU time gives on all cores at once. surfaces_share is that of the stage in the frame's
// time; transfer_s is what radiance transfer took before, once. With BRUME_BENCHMARK_IMAGES=folder
// each scene's last frame is written there.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/io/image/image_file.h"
#include "core/scene/mesh.h"
#include "render/display/to_display.h"
#include "render/quality/error_estimate.h"
#include "render/render_plan.h"
#include "render/renderer.h"
#include "render/transfer/transfer_store.h"
#include "tools/bench/scenes/benchmark_scenes.h"
#include "tools/bench/scenes/table_one_scenes.h"

namespace brume {
namespace {

constexpr int frames = 20;

// On a circle around the target, a third of a degree per frame.
Camera moved(Camera camera, int step) {
  const glm::dquat turn = glm::angleAxis(glm::radians(step / 3.0), glm::dvec3(0.0, 1.0, 0.0));
  camera.eye = camera.target + turn * (camera.eye - camera.target);
  return camera;
}

void check_counts(const TableOneScene& kind, const Scene& scene) {
  std::size_t vertices = 0;
  for (const Surface& surface : scene.surfaces) vertices += surface.mesh->n_vertices();
  if (vertices != kind.vertices || scene.medium.size() != kind.gaussians) {
    throw std::runtime_error(std::string(kind.name) + " is not the size that the paper states");
  }
}

void write_image(const char* name, const Frame& frame) {
  const char* folder = std::getenv("BRUME_BENCHMARK_IMAGES");
  if (!folder) return;
  write_png(std::filesystem::path(folder) / (std::string(name) + ".png"), frame.film.width,
            frame.film.height, to_display(frame, {}), {});
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

// Time is that of the median frame; stages are medians too.
void table_one(benchmark::State& state, const TableOneScene& kind) {
  const Scene scene = kind.make();
  check_counts(kind, scene);
  const auto transfers = std::make_shared<TransferStore>();
  const auto transfer_begin = std::chrono::steady_clock::now();
  transfers->make(needed_transfers(scene), {});
  state.counters["transfer_s"] =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - transfer_begin).count();
  Renderer renderer(transfers);
  const Settings settings = fewest_slices(renderer, scene);
  static_cast<void>(renderer.render(scene, scene.camera, scene.film, settings));

  std::vector<double> seconds;
  std::map<Stage, std::vector<double>> stages;
  Frame frame;
  Camera camera;
  double cpu = 0.0;
  const auto cores = static_cast<double>(std::thread::hardware_concurrency());
  for (auto _ : state) {
    for (int i = 1; i <= frames; ++i) {
      camera = moved(scene.camera, i);
      const double cpu_begin = cpu_seconds();
      const auto begin = std::chrono::steady_clock::now();
      frame = *renderer.render(scene, camera, scene.film, settings);
      seconds.push_back(
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
      cpu += cpu_seconds() - cpu_begin;
      for (const StageTime& stage : frame.statistics.stages) {
        stages[stage.stage].push_back(stage.milliseconds);
      }
    }
    state.SetIterationTime(median(seconds));
  }
  write_image(kind.name, frame);

  // Of the last frame, on other pixels than those that the slices were chosen on.
  const ErrorEstimate error =
      ErrorSample::create(scene, camera, frame, 1000, 2, 1e-3)->measure(frame);
  const double fps = 1.0 / median(seconds);
  state.counters["fps"] = fps;
  state.counters["fps_min"] = 1.0 / *std::ranges::max_element(seconds);
  state.counters["fps_max"] = 1.0 / *std::ranges::min_element(seconds);
  state.counters["fps_paper"] = kind.frames_per_second;
  state.counters["fps_over_paper"] = fps / kind.frames_per_second;
  const double wall = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  state.counters["cpu_ms"] = 1e3 * cpu / frames;
  state.counters["cpu_share"] = cpu / (wall * cores);
  state.counters["fps_alone"] = cores * frames / cpu;
  state.counters["error"] = error.rel_rmse;
  state.counters["error_low"] = error.low;
  state.counters["error_high"] = error.high;
  state.counters["slices"] = settings.slices;
  state.counters["exact_share"] = static_cast<double>(frame.statistics.exact_pixels) /
                                  (static_cast<double>(scene.film.width) * scene.film.height);
  for (const auto& [stage, times] : stages) {
    state.counters[std::string("ms_") + to_string(stage)] = median(times);
  }
  state.counters["surfaces_share"] = median(stages[Stage::surfaces]) / (1e3 * median(seconds));
}

[[maybe_unused]] const bool registered = [] {
  for (const TableOneScene& kind : table_one_scenes) {
    benchmark::RegisterBenchmark((std::string("table_one/") + kind.name).c_str(), table_one, kind)
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace brume
