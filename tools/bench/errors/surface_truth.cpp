#include "tools/bench/errors/surface_truth.h"

#include <tbb/parallel_for.h>

#include "core/scene/camera_rays.h"

namespace brume {

SurfaceTruth::SurfaceTruth(const Scene& scene, const SurfaceSampling& sampling)
    : SurfaceTruth(
          scene, sampling,
          [&](const RayCaster& ray_caster, const SurfacePoint& point, const SurfaceSampling& s) {
            return reflected_light(scene, ray_caster, point, s);
          }) {}

SurfaceTruth::SurfaceTruth(const Scene& scene, const SurfaceSampling& sampling, const Run& run) {
  const CameraRays rays(scene.camera, scene.film);
  const RayCaster ray_caster(scene.surfaces);
  std::vector<SurfacePoint> points;
  for (int y = 0; y < scene.film.height; ++y) {
    for (int x = 0; x < scene.film.width; ++x) {
      const glm::dvec3 w = rays.direction(x + 0.5, y + 0.5);
      const SurfaceHit hit = ray_caster.first_hit(rays.eye(), w);
      if (!hit) continue;
      pixels_.push_back(static_cast<std::size_t>(y * scene.film.width + x));
      points.push_back(ray_caster.point(hit, rays.eye(), w, scene.surfaces));
    }
  }
  for (std::size_t k = 0; k < independent_runs; ++k) {
    all_[k].resize(points.size());
    scattered_[k].resize(points.size());
  }
  tbb::parallel_for(std::size_t{0}, independent_runs * points.size(), [&](std::size_t n) {
    const std::size_t k = n / points.size();
    const std::size_t i = n % points.size();
    SurfaceSampling own_sampling = sampling;
    own_sampling.seed += n;
    const ReflectedLight light = run(ray_caster, points[i], own_sampling);
    all_[k][i] = light.attenuated + light.scattered;
    scattered_[k][i] = light.scattered;
  });
}

Runs SurfaceTruth::differences(const Frame& frame) const {
  Runs result = all_;
  for (std::size_t n = 0; n < pixels_.size(); ++n) {
    const std::size_t i = pixels_[n];
    for (std::size_t c = 0; c < 3; ++c) {
      const double got = static_cast<double>(frame.beauty[4 * i + c] - frame.airlight[3 * i + c]) /
                         static_cast<double>(frame.transmittance[3 * i + c]);
      for (auto& run : result) run[n][static_cast<int>(c)] -= got;
    }
  }
  return result;
}

ErrorEstimate SurfaceTruth::error(const Frame& frame) const {
  return unbiased_error(differences(frame), all_);
}

ErrorEstimate SurfaceTruth::scattered_error(const Frame& frame) const {
  return unbiased_error(differences(frame), scattered_);
}

}  // namespace brume
