#include "render/quality/view_reference.h"

#include <algorithm>

#include "render/util/job.h"

namespace brume {

ViewReference::ViewReference(const Scene& scene, const Camera& camera, const Film& film,
                             double tolerance, Scattering scattering) {
  const bool is_single = scattering == Scattering::single;
  const bool is_occluded = scene.environment && !scene.surfaces.empty();
  if (is_single || !is_occluded) reference_.emplace(scene, camera, film, tolerance);
  if (!is_single) {
    path_pixels_.emplace(scene, camera, film, paths,
                         reference_ ? PathPixels::Orders::after_first : PathPixels::Orders::all);
  }
}

bool ViewReference::evaluate(std::span<const std::size_t> pixels, const std::stop_token& stop,
                             const std::function<void(double)>& progress) {
  std::vector<std::size_t> unknown;
  std::ranges::copy_if(pixels, std::back_inserter(unknown),
                       [this](std::size_t pixel) { return !known_.contains(pixel); });
  const Job job{stop, progress};
  const double half = reference_ && path_pixels_ ? 0.5 : 1.0;
  std::vector<PixelAirlight> airlight(unknown.size());
  if (path_pixels_) {
    airlight = path_pixels_->airlight(unknown, stop, job.subrange(0.0, half).progress);
  }
  if (reference_) {
    const std::vector<glm::dvec3> first =
        reference_->airlight(unknown, stop, job.subrange(1.0 - half, 1.0).progress);
    for (std::size_t i = 0; i < std::min(first.size(), airlight.size()); ++i) {
      airlight[i].radiance += first[i];
    }
  }
  if (stop.stop_requested()) return false;
  for (std::size_t i = 0; i < unknown.size(); ++i) known_.emplace(unknown[i], airlight[i]);
  return true;
}

}  // namespace brume
