#include "tools/bench/cost_curves.h"

#include <tbb/info.h>

#include <algorithm>
#include <cmath>

#include "render/renderer.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

// After a first frame, which makes what the others keep.
MovedFrames cost(const Scene& scene, const Settings& settings, bool quick) {
  Renderer renderer;
  static_cast<void>(renderer.render(scene, scene.camera, scene.film, settings));
  return moved_frames(renderer, scene, settings, quick ? 3 : 9);
}

}  // namespace

std::vector<CostCurve> measure_cost_curves(const BenchOptions& options,
                                           const std::function<void(const std::string&)>& log) {
  Settings base;
  base.threads = options.threads;
  const auto cpu = [&](const Scene& scene, int slices) {
    return cost(scene, sliced_settings(base, slices), options.quick).cpu_milliseconds.median;
  };
  std::vector<CostCurve> curves;
  const auto add = [&](const char* over, const std::vector<int>& sizes, const auto& at) {
    log(std::string("cost over ") + over);
    CostCurve curve{over, {}, 0.0};
    for (const int size : sizes) curve.points.push_back({static_cast<double>(size), at(size)});
    curve.exponent = fitted_exponent(curve.points);
    curves.push_back(curve);
  };
  std::vector<int> counts = {100, 1000, 10'000};
  if (!options.quick) counts.insert(counts.end(), {100'000, 1'000'000});
  add("Gaussians", counts, [&](int n) { return cpu(box_scene(n, 1), 24); });
  add("lights", {1, 2, 4, 8}, [&](int n) { return cpu(box_scene(1000, n), 24); });
  add("slices", {8, 16, 32, 64, 128}, [&](int k) { return cpu(box_scene(1000, 1), k); });
  add("pixels", {7'500, 30'000, 120'000}, [&](int pixels) {
    Scene scene = box_scene(1000, 1);
    const int height = static_cast<int>(std::lround(std::sqrt(pixels * 0.75)));
    scene.film = {pixels / height, height};
    return cpu(scene, 24);
  });
  return curves;
}

std::vector<ThreadRow> measure_threads(const BenchOptions& options) {
  const int hardware = tbb::info::default_concurrency();
  const int all = options.threads > 0 ? std::min(options.threads, hardware) : hardware;
  Scene scene = box_scene(1000, 1);
  scene.film = {800, 600};
  std::vector<ThreadRow> rows;
  for (int threads = 1; threads <= all;
       threads = threads < all ? std::min(2 * threads, all) : all + 1) {
    Settings settings = sliced_settings({}, 24);
    settings.threads = threads;
    rows.push_back({threads, cost(scene, settings, options.quick).milliseconds});
  }
  return rows;
}

}  // namespace brume
