#include "tools/bench/errors/sample_errors.h"

#include <algorithm>

#include "brume/at_time.h"
#include "core/io/scene/scene_file.h"
#include "render/renderer.h"
#include "render/samples/mean_frame.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/measure/measurement.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

constexpr int true_samples = 64;
constexpr Film sampled_film{320, 240};

SampleRow measure_scene_samples(const std::string& name, int frames) {
  Scene scene = evaluate_at(load_scene(sample_scene_file(name)), 0.0);
  scene.film = sampled_film;
  Settings one = sliced_settings({}, 24);
  one.airlight_scale = 4;
  Settings chosen = one;
  chosen.samples = edge_samples;
  Settings all = one;
  all.samples = true_samples;

  Renderer renderer;
  const auto render = [&](const Camera& camera, const Film& film, const Settings& settings) {
    return renderer.render(scene, camera, film, settings);
  };
  const Frame plain = *render(scene.camera, scene.film, one);
  const Frame sampled = *render(scene.camera, scene.film, chosen);
  const Frame truth = *render_shifted(scene.film, all, {},
                                      [&](const Film& film, const Settings& settings, const Job&) {
                                        return render(scene.camera, film, settings);
                                      });
  std::vector<double> ratios;
  for (int k = 1; k <= frames; ++k) {
    const Camera camera = moved(scene.camera, {0.5, 1}, k);
    const auto milliseconds = [&](const Settings& settings) {
      return render(camera, scene.film, settings)->statistics.frame_milliseconds;
    };
    const double plain_milliseconds = milliseconds(one);
    ratios.push_back(milliseconds(chosen) / plain_milliseconds);
  }
  const auto pairs = [](const Frame& frame) {
    return static_cast<double>(std::max<std::uint64_t>(frame.statistics.view_pairs, 1));
  };
  // Alpha is as good as black: the same in all where surfaces are.
  return {name,
          rel_rmse(plain.beauty, truth.beauty),
          rel_rmse(sampled.beauty, truth.beauty),
          static_cast<double>(sampled.statistics.sampled_pixels) /
              static_cast<double>(sampled.depth.size()),
          pairs(sampled) / pairs(plain),
          spread_of(std::move(ratios)).median};
}

}  // namespace

std::vector<SampleRow> measure_samples(bool quick) {
  std::vector<SampleRow> rows;
  for (const char* name : {"courtyard", "bunny_fog", "forest", "harbour", "stage", "room"}) {
    rows.push_back(measure_scene_samples(name, quick ? 3 : 9));
    if (quick) break;
  }
  return rows;
}

}  // namespace brume
