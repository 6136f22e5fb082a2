#include "render/auto_quality.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace brume {
namespace {

// From cheap to costly. `paper` is not among them: with the same error it is never cheaper.
constexpr std::array<int, 8> ladder = {8, 12, 16, 24, 32, 48, 64, 128};

Settings with_slices(Settings settings, int slices) {
  settings.airlight = AirlightMethod::sliced;
  settings.slices = slices;
  settings.light_table = light_table_for(slices);
  return settings;
}

// A film of the same shape with about this many pixels.
Film small_film(const Film& film) {
  constexpr double pixels = 10'000.0;
  const double shrink =
      std::min(1.0, std::sqrt(pixels / (static_cast<double>(film.width) * film.height)));
  return {std::max(1, static_cast<int>(std::lround(shrink * film.width))),
          std::max(1, static_cast<int>(std::lround(shrink * film.height)))};
}

constexpr std::size_t sample_pixels = 192;
constexpr double sample_tolerance = 1e-3;

}  // namespace

std::optional<Settings> choose_settings(Renderer& renderer, const Scene& scene,
                                        const Camera& camera, const Film& film,
                                        const Settings& settings, double max_error,
                                        std::stop_token stop) {
  const Film small = small_film(film);
  std::optional<ErrorSample> sample;
  for (const int slices : ladder) {
    const Settings tried = with_slices(settings, slices);
    const std::optional<Frame> frame = renderer.render(scene, camera, small, tried, stop);
    if (!frame) return std::nullopt;
    if (!sample) {
      sample = ErrorSample::take(scene, camera, *frame, sample_pixels, 1, sample_tolerance, stop);
      if (!sample) return std::nullopt;
    }
    if (sample->measure(*frame).high <= max_error) return tried;
  }
  return with_slices(settings, ladder.back());
}

std::optional<Settings> better_settings(const Settings& settings) {
  const auto next = std::upper_bound(ladder.begin(), ladder.end(), settings.slices);
  if (next == ladder.end()) return std::nullopt;
  return with_slices(settings, *next);
}

}  // namespace brume
