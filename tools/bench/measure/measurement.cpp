#include "tools/bench/measure/measurement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <map>
#include <numeric>

#include "tools/bench/measure/frames.h"

namespace brume {
double Stopwatch::milliseconds() const {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_)
      .count();
}

double Stopwatch::cpu_milliseconds() const {
  return 1e3 * (cpu_seconds() - cpu_begin_);
}

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
  const Stopwatch watch;
  ErrorSample sample = *ErrorSample::create(scene, scene.camera, guide, pixels, 1, tolerance);
  const double film = static_cast<double>(scene.film.width) * scene.film.height;
  return {std::move(sample), watch.cpu_milliseconds() * film / static_cast<double>(pixels)};
}

MovedFrames moved_frames(FrameRenderer& renderer, const Scene& scene, const Settings& settings,
                         int min_frames, double seconds, const CameraStep& step) {
  constexpr int max_frames = 15;
  std::vector<double> times;
  std::vector<double> cpu_times;
  std::map<Stage, std::vector<double>> stages;
  std::vector<Stage> order;
  const Stopwatch all;
  for (int i = 1; i <= std::max(min_frames, max_frames); ++i) {
    if (i > min_frames && all.milliseconds() > 1e3 * seconds) break;
    // Nothing of the last view can be used again.
    const Camera camera = moved(scene.camera, step, step.first + i - 1);
    const Stopwatch watch;
    const Frame frame = *renderer.render(scene, camera, scene.film, settings);
    cpu_times.push_back(watch.cpu_milliseconds());
    times.push_back(watch.milliseconds());
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

Spread frame_time_ratio(int rounds, const std::function<double(std::size_t k, int i)>& render) {
  std::vector<double> ratios;
  for (int i = 0; i <= rounds; ++i) {
    const double first = render(0, i);
    const double second = render(1, i);
    if (i > 0) ratios.push_back(second / first);
  }
  return spread_of(std::move(ratios));
}

Spread frame_time_ratio(std::array<Renderer, 2> renderers, const Scene& scene,
                        const std::array<Settings, 2>& settings, int frames,
                        const CameraStep& step) {
  return frame_time_ratio(frames, [&](std::size_t k, int i) {
    const Frame frame =
        *renderers[k].render(scene, moved(scene.camera, step, i), scene.film, settings[k]);
    return frame.statistics.frame_milliseconds;
  });
}

Measurement measure(FrameRenderer& renderer, const Scene& scene, const Settings& settings,
                    const ErrorSample& reference, double seconds, const CameraStep& step) {
  Measurement result;
  result.setting = setting_name(settings);
  result.settings = settings;
  const Stopwatch watch;
  const Frame first = render_frame(renderer, scene, settings);
  result.first_milliseconds = watch.milliseconds();
  result.first_cpu_milliseconds = watch.cpu_milliseconds();
  result.error = reference.measure(first);
  result.pairs = first.statistics.view_pairs;
  static_cast<MovedFrames&>(result) = moved_frames(renderer, scene, settings, 3, seconds, step);
  return result;
}

std::vector<std::size_t> frontier(std::span<const Measurement> settings) {
  std::vector<std::size_t> order(settings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return settings[i].cpu_milliseconds.median; });
  std::vector<std::size_t> result;
  double min_error = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (!(settings[i].error.rel_rmse < min_error)) continue;
    min_error = settings[i].error.rel_rmse;
    result.push_back(i);
  }
  return result;
}

std::optional<std::size_t> cheapest_within(std::span<const Measurement> settings, double error) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (!(settings[i].error.high <= error)) continue;
    if (!best || settings[i].cpu_milliseconds.median < settings[*best].cpu_milliseconds.median) {
      best = i;
    }
  }
  return best;
}

double fitted_exponent(std::span<const CostPoint> points) {
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  for (const CostPoint& point : points) {
    const double u = std::log(point.size);
    const double v = std::log(point.cpu_milliseconds);
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  const auto n = static_cast<double>(points.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

namespace {

constexpr double max_error = 0.02;

FogBankRow measure_bank(int count, bool quick) {
  const Scene scene = fog_bank(count);
  const ReferenceSample reference = find_reference(scene, quick ? 50 : 200, 1e-3);
  FogBankRow row{.gaussians = count};
  for (const int slices : {8, 12, 16, 24, 32, 48}) {
    Settings settings = sliced_settings({}, slices);
    settings.airlight_scale = 4;
    Renderer renderer;
    row.measurement = measure(renderer, scene, settings, reference.sample, quick ? 0.5 : 2.0);
    if (row.measurement.error.rel_rmse <= max_error) break;
  }
  const Settings& merging = row.measurement.settings;
  Renderer renderer;
  const auto frame = renderer.render(scene, scene.camera, scene.film, merging);
  row.merged = frame->statistics.gaussians_merged;
  Settings plain = merging;
  plain.merge_error = 0.0;
  row.unmerged_ratio =
      frame_time_ratio({Renderer(), Renderer()}, scene, {merging, plain}, quick ? 3 : 9);
  return row;
}

}  // namespace

std::vector<FogBankRow> measure_fog_banks(bool quick) {
  std::vector<int> counts{10'000};
  if (!quick) counts.insert(counts.end(), {100'000, 1'000'000});
  std::vector<FogBankRow> rows;
  for (const int count : counts) rows.push_back(measure_bank(count, quick));
  return rows;
}

}  // namespace brume
