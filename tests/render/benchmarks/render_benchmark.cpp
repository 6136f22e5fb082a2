// The speed claims rest on these. Every figure is a ratio or comes with its answer's error, both
// from the same run. Run it alone on the machine:
//
//   build/release/bin/benchmark_render

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "core/io/scene/scene_file.h"
#include "render/optical_depth/path_depths.h"
#include "render/output/compare.h"
#include "render/renderer.h"
#include "render/util/frame_memory.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

// The cost of the method itself: everything but casting rays at surfaces and writing the frame.
double airlight_milliseconds(const Frame& frame) {
  const StageSet of_method{Stage::light_depth, Stage::eye_depth, Stage::airlight};
  double sum = 0.0;
  for (const StageTime& stage : frame.statistics.stages) {
    if (of_method.has(stage.stage)) sum += stage.milliseconds;
  }
  return sum;
}

// `paper` on the box of 3,008 Gaussians, SIMD float against plain double on one thread: time is
// that of SIMD, plain_over_simd the ratio per thread, rel_rmse the difference of the two airlights.
void paper_simd_against_plain(benchmark::State& state) {
  const Scene scene = load_scene(sample_scene_file("box_3008"));
  Settings simd{.airlight = AirlightMethod::paper};
  simd.threads = 1;
  Settings plain = simd;
  plain.precision = Settings::Precision::plain_double;
  for (auto _ : state) {
    // New renderers: nothing is kept from the frame before.
    const Frame fast = *Renderer().render(scene, scene.camera, scene.film, simd);
    const Frame slow = *Renderer().render(scene, scene.camera, scene.film, plain);
    state.SetIterationTime(1e-3 * airlight_milliseconds(fast));
    state.counters["plain_over_simd"] = airlight_milliseconds(slow) / airlight_milliseconds(fast);
    state.counters["rel_rmse"] =
        compare(std::array{ChannelPair{fast.airlight, slow.airlight}}).rel_rmse;
    state.counters["pairs"] = static_cast<double>(fast.statistics.view_pairs);
  }
}
BENCHMARK(paper_simd_against_plain)
    ->UseManualTime()
    ->Iterations(1)
    ->Repetitions(3)
    ->Unit(benchmark::kMillisecond);

// T(s, b_i) of all n Gaussians from a light, tree included: grows like n log n. rel_error compares
// 100 of them with the sum over all n in double.
void depths_of_n_gaussians(benchmark::State& state) {
  const Medium medium = box_of(static_cast<int>(state.range(0)));
  const glm::dvec3 light(2.0, 3.0, 2.5);
  CenterDepths result;
  for (auto _ : state) {
    const MediumIndex index(medium, culling_tolerance(medium, 1e-3));
    result = center_depths(index, light, Settings::Precision::simd_float);
    benchmark::DoNotOptimize(result.depths.data());
  }
  double error2 = 0.0;
  double sum2 = 0.0;
  for (std::size_t i = 0; i < medium.size(); i += medium.size() / 100) {
    double reference = 0.0;
    for (std::size_t j = 0; j < medium.size(); ++j) {
      if (j == i) continue;
      reference += optical_depth(medium.gaussian(j), light, medium.centers()[i]);
    }
    error2 += (result.depths[i] - reference) * (result.depths[i] - reference);
    sum2 += reference * reference;
  }
  const double n = static_cast<double>(state.range(0));
  state.SetComplexityN(state.range(0));
  state.counters["pairs_per_path"] = static_cast<double>(result.pairs) / n;
  state.counters["rel_error"] = std::sqrt(error2 / sum2);
}
BENCHMARK(depths_of_n_gaussians)
    ->RangeMultiplier(2)
    ->Range(1000, 64000)
    ->Complexity(benchmark::oNLogN)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace brume

int main(int argc, char** argv) {
  brume::keep_frame_memory();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
