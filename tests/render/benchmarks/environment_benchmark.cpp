// The light of an environment in clouds: CPU time of the grid, and of the view pass with it over
// that without, and the error of the airlight against the reference.

#include <benchmark/benchmark.h>

#include <cmath>

#include "render/quality/auto_quality.h"
#include "render/renderer.h"
#include "render/scattering/source_function.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

// The grid of n Gaussians, and frames with k slices, at an anisotropy of a tenth of the third
// argument; with_surfaces_ms is what the grid takes where surfaces receive light.
void environment(benchmark::State& state) {
  Scene scene = box_scene(static_cast<int>(state.range(0)), 0);
  scene.film = {200, 150};
  scene.optics.anisotropy = 0.1 * static_cast<double>(state.range(2));
  const Settings settings = sliced_settings({}, static_cast<int>(state.range(1)));
  Renderer renderer;
  const auto frame_seconds = [&] {
    renderer.render(scene, scene.camera, scene.film, settings);
    const double start = cpu_seconds();
    for (int i = 0; i < 5; ++i) renderer.render(scene, scene.camera, scene.film, settings);
    return (cpu_seconds() - start) / 5.0;
  };
  const double dark = frame_seconds();
  scene.environment.emplace().map = sunny_sky();
  const double lit = frame_seconds();
  SourceFunction source;
  const auto grid_seconds = [&](const std::optional<SourceGrid::Receivers>& receivers) {
    const double start = cpu_seconds();
    scene.environment->rotation += 1.0;
    source.update({&*scene.environment,
                   scene.medium,
                   scene.optics.anisotropy,
                   0.0,
                   {},
                   {},
                   receivers,
                   settings.source_grid,
                   {}},
                  Job{});
    return cpu_seconds() - start;
  };
  for (auto _ : state) state.SetIterationTime(grid_seconds({}));
  IncidentOptics optics;
  optics.anisotropy = scene.optics.anisotropy;
  state.counters["with_surfaces_ms"] = 1e3 * grid_seconds(SourceGrid::Receivers{{}, optics});
  const Frame frame = *renderer.render(scene, scene.camera, scene.film, settings);
  state.counters["lit_over_dark"] = lit / dark;
  state.counters["frame_ms"] = 1e3 * lit;
  state.counters["rel_rmse"] = measure_error(scene, scene.camera, frame)->airlight.rel_rmse;
}
BENCHMARK(environment)
    ->ArgsProduct({{30, 300, 3000}, {8, 24, 64}, {0, 6}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace brume
