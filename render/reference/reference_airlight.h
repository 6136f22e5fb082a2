#pragma once

#include <span>
#include <vector>

#include "brume/scene.h"
#include "render/geometry/medium_index.h"
#include "render/geometry/point_source.h"
#include "render/lights/distant_lights.h"
#include "render/reference/airlight_integral.h"
#include "render/visibility/exact_occlusion.h"

namespace brume {

// Environment light scattered once towards the eye, converged, in double with exact optical depths:
//   integral over the view ray of b exp(-T(v, x)) J(x, w) dt,
//   J(x, w) = integral over directions w' of p(w, w') L(w') exp(-T(x, w')).
// Not occluded by surfaces.
class ReferenceEnvironment {
 public:
  // `fog_depth`: optical depth of b0 from any point to the end of the fog, of which
  // MediumIndex::fog() knows nothing. Sampling the medium's transmittance at discrete directions
  // has a relative error of about `tolerance`; the phase function is sampled at full resolution.
  ReferenceEnvironment(const Environment& environment, double anisotropy, double fog_depth,
                       double tolerance);

  // J at x for a view direction w; exact up to the medium's tolerance, apart from the sampled
  // directions.
  [[nodiscard]] glm::dvec3 source(const MediumIndex& medium, const glm::dvec3& x,
                                  const glm::dvec3& w) const;

  // The integral along a view ray, to a relative error of `tolerance`.
  [[nodiscard]] glm::dvec3 airlight(const MediumIndex& medium, const ViewRayMedium<double>& ray,
                                    double tolerance) const;

 private:
  // Unattenuated scattering of each cluster along w, and its weighted mean direction.
  [[nodiscard]] std::vector<DistantLight> scattered_along(const glm::dvec3& w) const;
  [[nodiscard]] glm::dvec3 sum(const MediumIndex& medium, const glm::dvec3& x,
                               std::span<const DistantLight> scattered) const;

  double anisotropy_;
  double attenuation_;  // transmittance of the fog
  std::vector<LightGroup> groups_;
};

// The converged airlight of one view ray: all lights with shadows of surfaces, b0 and Gaussians,
// and the environment, which surfaces do not occlude.

struct ReferenceRay {
  glm::dvec3 airlight{0.0};  // RGB radiance
  double depth = 0.0;        // T(v, p), b0 included; +inf possible
  std::uint64_t view_pairs = 0;
  std::uint64_t light_pairs = 0;
};

// `length`: distance to the first surface or +inf; `environment`: may be null; `tolerance`:
// relative, see airlight_integral(). Thread-safe.
ReferenceRay reference_airlight(const MediumIndex& medium, const ExactOcclusion& exact_occlusion,
                                std::span<const PointSource> lights,
                                const ReferenceEnvironment* environment, const glm::dvec3& eye,
                                const glm::dvec3& w, double length, double tolerance);

}  // namespace brume
