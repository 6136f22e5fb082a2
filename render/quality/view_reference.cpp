#include "render/quality/view_reference.h"

#include <algorithm>

namespace brume {

ViewReference::ViewReference(const Scene& scene, const Camera& camera, const Film& film,
                             double tolerance, Scattering scattering) {
  if (scattering == Scattering::single) {
    reference_.emplace(scene, camera, film, tolerance);
  } else {
    path_pixels_.emplace(scene, camera, film, paths);
  }
}

bool ViewReference::evaluate(std::span<const std::size_t> pixels, const std::stop_token& stop,
                             const std::function<void(double)>& progress) {
  std::vector<std::size_t> unknown;
  std::ranges::copy_if(pixels, std::back_inserter(unknown),
                       [this](std::size_t pixel) { return !known_.contains(pixel); });
  std::vector<PixelAirlight> airlight;
  if (path_pixels_) {
    airlight = path_pixels_->airlight(unknown, stop, progress);
  } else {
    for (const glm::dvec3& radiance : reference_->airlight(unknown, stop, progress)) {
      airlight.push_back({radiance, 0.0});
    }
  }
  if (airlight.size() != unknown.size()) return false;
  for (std::size_t i = 0; i < unknown.size(); ++i) known_.emplace(unknown[i], airlight[i]);
  return true;
}

}  // namespace brume
