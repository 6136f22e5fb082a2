#pragma once

#include <functional>
#include <optional>
#include <unordered_map>

#include "render/quality/path_pixels.h"
#include "render/reference/reference_pixels.h"
#include "render/settings.h"

namespace brume {

// Caches what the airlight of one view's pixels ought to be. Not thread-safe.
class ViewReference {
 public:
  // Scattered once: converged, see ReferencePixels. More often: by PathPixels, which are noisy; all
  // orders where surfaces keep an environment out, which the former do not know.
  ViewReference(const Scene& scene, const Camera& camera, const Film& film, double tolerance,
                Scattering scattering = Scattering::single);

  // Evaluates pixels that are not cached, in parallel, milliseconds each. False if `stop` was
  // requested. `progress`: see FrameRenderer.
  bool evaluate(std::span<const std::size_t> pixels, const std::stop_token& stop,
                const std::function<void(double)>& progress = {});

  // Airlight of an evaluated pixel.
  [[nodiscard]] const PixelAirlight& airlight(std::size_t pixel) const { return known_.at(pixel); }

  // Number of evaluated pixels.
  [[nodiscard]] std::size_t size() const { return known_.size(); }

  // Paths of a pixel. With as many the noise of a pixel is a few percent; that of an error measured
  // on a hundred pixels is a few tenths of a percent.
  static constexpr int paths = 1024;

 private:
  std::optional<ReferencePixels> reference_;
  std::optional<PathPixels> path_pixels_;
  std::unordered_map<std::size_t, PixelAirlight> known_;
};

}  // namespace brume
