#include "render/auto_quality.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/job.h"

namespace brume {
namespace {

// A film of the same shape with about this many pixels.
Film small_film(const Film& film) {
  constexpr double pixels = 10'000.0;
  const double shrink =
      std::min(1.0, std::sqrt(pixels / (static_cast<double>(film.width) * film.height)));
  return {std::max(1, static_cast<int>(std::lround(shrink * film.width))),
          std::max(1, static_cast<int>(std::lround(shrink * film.height)))};
}

// The reference takes time per pixel that grows with the number of Gaussians, and more where light
// comes from all around; the sample shrinks with it, by count and not by clock, so that the same
// scene always gets the same settings.
std::size_t sample_pixels(const Scene& scene) {
  const std::size_t most = scene.environment ? 96 : 192;
  return std::clamp<std::size_t>(1'000'000 / (scene.medium.size() + 1), 48, most);
}

constexpr double sample_tolerance = 1e-3;

// The settings after these, if there are any better.
std::optional<Settings> better_settings(const Settings& settings) {
  const std::vector<Settings> ladder = quality_ladder(settings);
  const auto at = std::find(ladder.begin(), ladder.end(), settings);
  if (at == ladder.end() || at + 1 == ladder.end()) return std::nullopt;
  return *(at + 1);
}

}  // namespace

std::vector<Settings> quality_ladder(const Settings& settings) {
  // `paper` is not among them: with the same error it is never cheaper.
  std::vector<Settings> ladder;
  for (const int slices : {8, 12, 16, 24, 32, 48, 64, 128}) {
    ladder.push_back(sliced_settings(settings, slices));
  }
  return ladder;
}

std::optional<ErrorSample> take_error_sample(const Scene& scene, const Camera& camera,
                                             const Frame& guide, std::uint64_t seed,
                                             std::stop_token stop,
                                             const std::function<void(double)>& progress) {
  return ErrorSample::take(scene, camera, guide, sample_pixels(scene), seed, sample_tolerance, stop,
                           progress);
}

std::optional<Settings> choose_settings(FrameRenderer& renderer, const Scene& scene,
                                        const Camera& camera, const Film& film,
                                        const Settings& settings, double max_error,
                                        std::stop_token stop,
                                        const std::function<void(double)>& progress) {
  // The sample takes most of the time, then each trial about as much as all before it.
  const Job job{stop, progress};
  const Job measuring = job.part(0.0, 0.6);
  double begin = 0.6;
  const Film small = small_film(film);
  const std::vector<Settings> ladder = quality_ladder(settings);
  std::optional<ErrorSample> sample;
  for (const Settings& tried : ladder) {
    const std::optional<Frame> frame = renderer.render(scene, camera, small, tried, stop);
    if (!frame) return std::nullopt;
    if (!sample) {
      sample = take_error_sample(scene, camera, *frame, 1, stop, measuring.progress);
      if (!sample) return std::nullopt;
    }
    begin += 0.5 * (1.0 - begin);
    if (progress) progress(begin);
    if (sample->measure(*frame).high <= max_error) return tried;
  }
  return ladder.back();
}

std::optional<ErrorEstimate> measure_error(const Scene& scene, const Camera& camera,
                                           const Frame& frame, std::stop_token stop,
                                           const std::function<void(double)>& progress) {
  // Another seed than that of the choice: settings chosen to do well on some pixels must not be
  // judged by the same ones.
  const auto sample = take_error_sample(scene, camera, frame, 2, stop, progress);
  if (!sample) return std::nullopt;
  return sample->measure(frame);
}

std::optional<MeasuredFrame> render_auto(FrameRenderer& renderer, const Scene& scene,
                                         const Camera& camera, const Film& film,
                                         const Settings& settings, double max_error,
                                         std::stop_token stop,
                                         const std::function<void(double)>& progress) {
  const Job job{stop, progress};
  double begin = 0.4;
  std::optional<Settings> tried = choose_settings(renderer, scene, camera, film, settings,
                                                  max_error, stop, job.part(0.0, begin).progress);
  std::optional<MeasuredFrame> result;
  while (tried) {
    // Seldom is more than one frame needed.
    const double end = begin + 0.8 * (1.0 - begin);
    const double middle = 0.5 * (begin + end);
    std::optional<Frame> frame =
        renderer.render(scene, camera, film, *tried, stop, job.part(begin, middle).progress);
    if (!frame) return std::nullopt;
    const std::optional<ErrorEstimate> error =
        measure_error(scene, camera, *frame, stop, job.part(middle, end).progress);
    if (!error) return std::nullopt;
    result = MeasuredFrame{std::move(*frame), *tried, *error};
    if (error->high <= max_error) break;
    tried = better_settings(*tried);
    begin = end;
  }
  return result;
}

}  // namespace brume
