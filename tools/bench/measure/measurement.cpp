#include "tools/bench/measure/measurement.h"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>

#include "tools/bench/measure/frames.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

}  // namespace

Camera moved(Camera camera, const CameraStep& step, int steps) {
  const glm::dvec3 from_target = camera.eye - camera.target;
  if (step.turn == 0.0) {
    camera.eye -= steps * 1e-6 * from_target;
  } else {
    const glm::dquat turn =
        glm::angleAxis(glm::radians(steps * step.turn), glm::normalize(camera.up));
    camera.eye = camera.target + turn * from_target;
  }
  return camera;
}

std::string setting_name(const Settings& settings) {
  std::string name = airlight_name(settings);
  // Older reports, with which new ones are compared, call it so.
  if (settings.airlight == AirlightMethod::sliced) name[name.find(':')] = ' ';
  if (settings.airlight_scale > 1) name += ", scale " + std::to_string(settings.airlight_scale);
  return name;
}

ReferenceSample find_reference(const Scene& scene, std::size_t pixels, double tolerance) {
  const Frame guide = render_frame(scene, sliced_settings({}, 12));
  const double begin = cpu_seconds();
  ErrorSample sample = *ErrorSample::create(scene, scene.camera, guide, pixels, 1, tolerance);
  const double film = static_cast<double>(scene.film.width) * scene.film.height;
  return {std::move(sample), 1e3 * (cpu_seconds() - begin) * film / static_cast<double>(pixels)};
}

MovedFrames moved_frames(FrameRenderer& renderer, const Scene& scene, const Settings& settings,
                         int min_frames, double seconds, const CameraStep& step) {
  constexpr int max_frames = 15;
  std::vector<double> times;
  std::vector<double> cpu_times;
  std::map<Stage, std::vector<double>> stages;
  std::vector<Stage> order;
  const Clock::time_point begin = Clock::now();
  for (int i = 1; i <= std::max(min_frames, max_frames); ++i) {
    if (i > min_frames && milliseconds_since(begin) > 1e3 * seconds) break;
    // Nothing of the last view can be used again.
    const Camera camera = moved(scene.camera, step, step.first + i - 1);
    const Clock::time_point start = Clock::now();
    const double cpu_start = cpu_seconds();
    const Frame frame = *renderer.render(scene, camera, scene.film, settings);
    cpu_times.push_back(1e3 * (cpu_seconds() - cpu_start));
    times.push_back(milliseconds_since(start));
    for (const StageTime& stage : frame.statistics.stages) {
      if (!stages.contains(stage.stage)) order.push_back(stage.stage);
      stages[stage.stage].push_back(stage.milliseconds);
    }
  }
  MovedFrames result{spread_of(times), spread_of(cpu_times), {}};
  for (const Stage stage : order) {
    result.stages.push_back({stage, spread_of(stages[stage]).median});
  }
  return result;
}

Spread frame_time_ratio(std::array<Renderer, 2> renderers, const Scene& scene,
                        const std::array<Settings, 2>& settings, int frames,
                        const CameraStep& step) {
  std::vector<double> ratios;
  for (int i = 0; i <= frames; ++i) {
    const Camera camera = moved(scene.camera, step, i);
    std::array<double, 2> milliseconds{};
    for (std::size_t k = 0; k < 2; ++k) {
      const Frame frame = *renderers[k].render(scene, camera, scene.film, settings[k]);
      milliseconds[k] = frame.statistics.frame_milliseconds;
    }
    if (i > 0) ratios.push_back(milliseconds[1] / milliseconds[0]);
  }
  return spread_of(std::move(ratios));
}

Measurement measure(FrameRenderer& renderer, const Scene& scene, const Settings& settings,
                    const ErrorSample& reference, double seconds, const CameraStep& step) {
  Measurement result;
  result.setting = setting_name(settings);
  result.settings = settings;
  const Clock::time_point begin = Clock::now();
  const double cpu_begin = cpu_seconds();
  const Frame first = render_frame(renderer, scene, settings);
  result.first_milliseconds = milliseconds_since(begin);
  result.first_cpu_milliseconds = 1e3 * (cpu_seconds() - cpu_begin);
  result.error = reference.measure(first);
  result.pairs = first.statistics.view_pairs;
  static_cast<MovedFrames&>(result) = moved_frames(renderer, scene, settings, 3, seconds, step);
  return result;
}

}  // namespace brume
