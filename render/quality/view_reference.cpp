#include "render/quality/view_reference.h"

#include <algorithm>

#include "core/scene/lights/emitting_surfaces.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/materials/coverage.h"
#include "render/quality/work.h"
#include "render/util/job.h"

namespace brume {
namespace {

bool has_area_lights(const Scene& scene) {
  if (std::ranges::any_of(scene.surfaces, is_emissive)) return true;
  return std::ranges::any_of(scene.lights, [](const Light& light) {
    return light.on && area_of(light) && light.intensity != glm::dvec3(0.0);
  });
}

}  // namespace

ViewReference::ViewReference(const Scene& scene, const Camera& camera, const Film& film,
                             double tolerance, Scattering scattering, Measured measured)
    : has_picture_(measured == Measured::airlight_and_picture) {
  const bool is_single = scattering == Scattering::single;
  // Neither surfaces nor the end of the fog are on the way of the integral's environment.
  const bool has_other_environment =
      scene.environment && (!scene.surfaces.empty() || scene.medium.homogeneous_density() > 0.0);
  constexpr double max_integral_work = 3e7;  // that of thousands of paths
  const bool has_panes = brume::has_panes(scene.surfaces);
  if (is_single || !(has_other_environment || has_panes)) {
    using enum ReferencePixels::Lights;
    reference_.emplace(scene, camera, film, tolerance, has_panes ? none : without_area);
    integral_work_ = brume::integral_work(scene.medium.size(), reference_->light_count(),
                                          reference_->has_environment());
    if (!is_single && integral_work_ > max_integral_work) {
      reference_.reset();
      integral_work_ = 0.0;
    }
  }
  // Whether they are what the truth has of light that is scattered once.
  keeps_integrals_ = reference_ && !has_other_environment && !has_panes;
  using enum PathPixels::Orders;
  PathPixels::Orders airlight = none;
  if (!is_single) {
    airlight = reference_ ? all_but_integrals : all;
  } else if (has_area_lights(scene) || has_panes) {
    airlight = integrals_lack_once;
  }
  has_noisy_airlight_ = airlight != none;
  PathPixels::Orders picture = none;
  if (has_picture_) picture = keeps_integrals_ ? all_but_integrals : all;
  if (airlight != none || picture != none) {
    path_pixels_.emplace(scene, camera, film, airlight, picture);
  }
}

bool ViewReference::evaluate(std::span<const std::size_t> pixels,
                             const std::function<int(std::size_t)>& paths,
                             const std::stop_token& stop,
                             const std::function<void(double)>& progress) {
  const Job job{stop, progress};
  const double half = reference_ && path_pixels_ ? 0.5 : 1.0;
  std::vector<std::size_t> unknown;
  std::vector<std::size_t> noisy;
  for (const std::size_t pixel : pixels) {
    const auto known = known_.find(pixel);
    if (known == known_.end()) unknown.push_back(pixel);
    if (known == known_.end() || known->second.paths.count < paths(pixel)) noisy.push_back(pixel);
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
    path_pixels_->trace(noisy[i], paths(noisy[i]), traced[i], stop);
  });
  if (stop.stop_requested()) return false;

  work_.integrals += integral_work_ * static_cast<double>(unknown.size());
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    Pixel& pixel = known_[unknown[i]];
    pixel.exact = exact[i];
    pixel.airlight = {exact[i], 0.0};
  }
  for (std::size_t i = 0; i < traced.size(); ++i) {
    Pixel& pixel = known_.at(noisy[i]);
    work_.paths += traced[i].work - pixel.paths.work;
    pixel.paths = traced[i];
    pixel.airlight = path_pixels_->airlight(traced[i]);
    pixel.airlight.radiance += pixel.exact;
    if (!has_picture_) continue;
    pixel.picture = path_pixels_->picture(traced[i]);
    if (keeps_integrals_) pixel.picture.radiance += pixel.exact;
  }
  return true;
}

}  // namespace brume
