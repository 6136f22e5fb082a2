#include "render/quality/view_reference.h"

#include <algorithm>

#include "render/util/job.h"

namespace brume {

ViewReference::ViewReference(const Scene& scene, const Camera& camera, const Film& film,
                             double tolerance, Scattering scattering) {
  const bool is_single = scattering == Scattering::single;
  // Neither surfaces nor the end of the fog are on the way of the integral's environment.
  const bool has_other_environment =
      scene.environment && (!scene.surfaces.empty() || scene.medium.homogeneous_density() > 0.0);
  if (is_single || !has_other_environment) reference_.emplace(scene, camera, film, tolerance);
  if (!is_single) {
    path_pixels_.emplace(scene, camera, film,
                         reference_ ? PathPixels::Orders::after_first : PathPixels::Orders::all);
  }
}

bool ViewReference::evaluate(std::span<const std::size_t> pixels, int paths,
                             const std::stop_token& stop,
                             const std::function<void(double)>& progress) {
  const Job job{stop, progress};
  const double half = reference_ && path_pixels_ ? 0.5 : 1.0;
  std::vector<std::size_t> unknown;
  std::vector<std::size_t> noisy;
  for (const std::size_t pixel : pixels) {
    const auto known = known_.find(pixel);
    if (known == known_.end()) unknown.push_back(pixel);
    if (known == known_.end() || known->second.paths.count < paths) noisy.push_back(pixel);
  }
  std::vector<glm::dvec3> exact(unknown.size());
  if (reference_) exact = reference_->airlight(unknown, stop, job.subrange(0.0, half).progress);
  if (stop.stop_requested()) return false;

  std::vector<PixelPaths> traced(path_pixels_ ? noisy.size() : 0);
  const Job tracing = job.subrange(1.0 - half, 1.0);
  tracing.parallel_for_with_progress(traced.size(), [&](std::size_t i) {
    if (const auto known = known_.find(noisy[i]); known != known_.end()) {
      traced[i] = known->second.paths;
    }
    path_pixels_->trace(noisy[i], paths, traced[i], stop);
  });
  if (stop.stop_requested()) return false;

  for (std::size_t i = 0; i < unknown.size(); ++i) {
    Pixel& pixel = known_[unknown[i]];
    pixel.exact = exact[i];
    pixel.airlight = {exact[i], 0.0};
  }
  for (std::size_t i = 0; i < traced.size(); ++i) {
    Pixel& pixel = known_.at(noisy[i]);
    pixel.paths = traced[i];
    pixel.airlight = path_pixels_->airlight(traced[i]);
    pixel.airlight.radiance += pixel.exact;
  }
  return true;
}

}  // namespace brume
