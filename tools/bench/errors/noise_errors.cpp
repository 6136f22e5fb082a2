#include "tools/bench/errors/noise_errors.h"

#include <cmath>

#include "tools/bench/measure/frames.h"
#include "tools/bench/measure/report_text.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

double mean_depth(const Scene& scene) {
  const Frame frame = render_frame(scene, {.airlight = AirlightMethod::paper});
  double sum = 0.0;
  for (const float t : frame.transmittance) sum -= std::log(static_cast<double>(t));
  return sum / static_cast<double>(frame.transmittance.size());
}

// How the mean depth changes, over seeds.
Spread changes(Scene scene, double amplitude, double cells) {
  const double still = mean_depth(scene);
  scene.optics.noise.amplitude = amplitude;
  scene.optics.noise.frequency = cells;
  std::vector<double> all;
  for (int seed = 1; seed <= 8; ++seed) {
    scene.optics.noise.seed = seed;
    all.push_back(mean_depth(scene) / still - 1.0);
  }
  return spread_of(all);
}

ErrorEstimate sliced_error(const Scene& scene, std::size_t pixels) {
  const Settings settings = sliced_settings({}, 24);
  const Frame frame = render_frame(scene, settings);
  return ErrorSample::create(scene, scene.camera, frame, pixels, 1, 1e-5)->measure(frame);
}

}  // namespace

std::vector<NoiseDepthRow> measure_noise_depths() {
  Scene near = cloud(30, 1.0);
  near.film = {64, 64};
  Scene afar = near;
  afar.camera.eye.z *= 10.0;
  afar.camera.vertical_fov = 6.0;
  std::vector<NoiseDepthRow> rows;
  for (const double cells : {0.3, 1.0, 2.0, 5.0}) {
    rows.push_back({cells, changes(afar, 0.5, cells), changes(near, 0.5, cells)});
  }
  return rows;
}

std::vector<ComparedError> measure_noise_errors(std::size_t pixels) {
  std::vector<ComparedError> rows;
  const auto add = [&](int gaussians, double depth, double amplitude, double cells) {
    Scene scene = cloud(gaussians, depth);
    const ErrorEstimate still = sliced_error(scene, pixels);
    scene.optics.noise.amplitude = amplitude;
    scene.optics.noise.frequency = cells;
    rows.push_back({formatted("%d Gaussians %g deep, amplitude %g, %g cells per u", gaussians,
                              depth, amplitude, cells),
                    sliced_error(scene, pixels), still});
  };
  add(30, 1.0, 0.3, 2.0);
  add(30, 1.0, 0.5, 2.0);
  add(30, 1.0, 0.4, 8.0);
  add(300, 3.0, 0.4, 2.0);
  return rows;
}

}  // namespace brume
