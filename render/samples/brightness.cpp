#include "render/samples/brightness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace brume {
namespace {

// The rays of so small a picture cost less than a hundredth of what a frame of a megapixel does.
constexpr double probe_pixels = 1000.0;

bool needs_brightness(const Settings& settings) {
  return settings.airlight != AirlightMethod::path &&
         (settings.airlight_scale > 1 || settings.samples > 1);
}

}  // namespace

Brightness brightness_of(const Frame& frame, const CameraRays::PixelRectangle& pixels) {
  Brightness sum;
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    for (int x = pixels.x0; x < pixels.x1; ++x) {
      const std::size_t i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.film.width) +
          static_cast<std::size_t>(x);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto airlight = static_cast<double>(frame.airlight[3 * i + c]);
        const auto beauty = static_cast<double>(frame.beauty[4 * i + c]);
        sum.airlight_rms += airlight * airlight;
        sum.mean += beauty;
        sum.rms += beauty * beauty;
      }
    }
  }
  const double count =
      3.0 * std::max(pixels.x1 - pixels.x0, 1) * std::max(pixels.y1 - pixels.y0, 1);
  return {std::sqrt(sum.airlight_rms / count), sum.mean / count, std::sqrt(sum.rms / count)};
}

Film small_film(const Film& film, double pixels) {
  const glm::dvec2 whole = film.region
                               ? glm::dvec2(film.region->full_width, film.region->full_height)
                               : glm::dvec2(film.width, film.height);
  const double shrink = std::min(1.0, std::sqrt(pixels / (whole.x * whole.y)));
  const auto shrunk = [shrink](double side) {
    return std::max(1, static_cast<int>(std::lround(shrink * side)));
  };
  return {shrunk(whole.x), shrunk(whole.y)};
}

std::optional<Brightness> find_brightness(FrameRenderer& renderer, const Scene& scene,
                                          const Camera& camera, const Film& film,
                                          const Settings& settings, const Job& job) {
  Settings single = settings;
  single.airlight_scale = 1;
  single.samples = 1;
  const Film small = small_film(film, probe_pixels);
  const std::optional<Frame> frame =
      renderer.render(scene, camera, small, single, job.stop, job.progress);
  if (!frame) return std::nullopt;
  return brightness_of(*frame, {0, 0, small.width, small.height});
}

std::optional<Settings> with_brightness(FrameRenderer& renderer, const Scene& scene,
                                        const Camera& camera, const Film& film, Settings settings,
                                        const Job& job) {
  if (settings.brightness || !needs_brightness(settings)) return settings;
  settings.brightness = find_brightness(renderer, scene, camera, film, settings, job);
  if (!settings.brightness) return std::nullopt;
  return settings;
}

}  // namespace brume
