#include "render/auto_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace brume {
namespace {

// From cheap to costly. `paper` is not among them: with the same error it is never cheaper.
constexpr std::array<int, 8> ladder = {8, 12, 16, 24, 32, 48, 64, 128};

// A film of the same shape with about this many pixels.
Film small_film(const Film& film) {
  constexpr double pixels = 10'000.0;
  const double shrink =
      std::min(1.0, std::sqrt(pixels / (static_cast<double>(film.width) * film.height)));
  return {std::max(1, static_cast<int>(std::lround(shrink * film.width))),
          std::max(1, static_cast<int>(std::lround(shrink * film.height)))};
}

// The reference takes time per pixel that grows with the number of Gaussians; the sample shrinks
// with it, by count and not by clock, so that the same scene always gets the same settings.
std::size_t sample_pixels(const Scene& scene) {
  return std::clamp<std::size_t>(1'000'000 / (scene.medium.size() + 1), 48, 192);
}

constexpr double sample_tolerance = 1e-3;

// The settings after these, if there are any better.
std::optional<Settings> better_settings(const Settings& settings) {
  const auto next = std::upper_bound(ladder.begin(), ladder.end(), settings.slices);
  if (next == ladder.end()) return std::nullopt;
  return sliced_settings(settings, *next);
}

}  // namespace

std::optional<Settings> choose_settings(Renderer& renderer, const Scene& scene,
                                        const Camera& camera, const Film& film,
                                        const Settings& settings, double max_error,
                                        std::stop_token stop) {
  const Film small = small_film(film);
  std::optional<ErrorSample> sample;
  for (const int slices : ladder) {
    const Settings tried = sliced_settings(settings, slices);
    const std::optional<Frame> frame = renderer.render(scene, camera, small, tried, stop);
    if (!frame) return std::nullopt;
    if (!sample) {
      sample =
          ErrorSample::take(scene, camera, *frame, sample_pixels(scene), 1, sample_tolerance, stop);
      if (!sample) return std::nullopt;
    }
    if (sample->measure(*frame).high <= max_error) return tried;
  }
  return sliced_settings(settings, ladder.back());
}

std::optional<ErrorEstimate> measure_error(const Scene& scene, const Camera& camera,
                                           const Frame& frame, std::stop_token stop) {
  // Another seed than that of the choice: settings chosen to do well on some pixels must not be
  // judged by the same ones.
  const auto sample =
      ErrorSample::take(scene, camera, frame, sample_pixels(scene), 2, sample_tolerance, stop);
  if (!sample) return std::nullopt;
  return sample->measure(frame);
}

std::optional<MeasuredFrame> render_auto(Renderer& renderer, const Scene& scene,
                                         const Camera& camera, const Film& film,
                                         const Settings& settings, double max_error,
                                         std::stop_token stop,
                                         const std::function<void(double)>& progress) {
  std::optional<Settings> tried =
      choose_settings(renderer, scene, camera, film, settings, max_error, stop);
  std::optional<MeasuredFrame> result;
  while (tried) {
    std::optional<Frame> frame = renderer.render(scene, camera, film, *tried, stop, progress);
    if (!frame) return std::nullopt;
    const std::optional<ErrorEstimate> error = measure_error(scene, camera, *frame, stop);
    if (!error) return std::nullopt;
    result = MeasuredFrame{std::move(*frame), *tried, *error};
    if (error->high <= max_error) break;
    tried = better_settings(*tried);
  }
  return result;
}

}  // namespace brume
