#pragma once

#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "render/distant_lights.h"
#include "render/medium_index.h"
#include "render/reference/airlight_integral.h"

namespace brume {

// Light of an environment that the medium scatters once towards the eye, converged, in double and
// with exact optical depths:
//   integral over the view ray of b exp(-T(v, x)) J(x, w) dt,
//   J(x, w) = integral over directions w' of p(w, w') L(w') exp(-T(x, w')).
// Surfaces do not block this light.
class ReferenceEnvironment {
 public:
  // `fog_depth`: optical depth of the homogeneous part from any point to where the fog ends. The
  // error of taking the medium's transmittance at so many directions is about `tolerance`,
  // relative; the phase function is taken at all of the map.
  ReferenceEnvironment(const Environment& environment, double anisotropy, double fog_depth,
                       double tolerance);

  // J at x towards an eye that looks along the unit vector w; exact up to the medium's tolerance on
  // depths, but for the steps.
  [[nodiscard]] glm::dvec3 source(const MediumIndex& medium, const glm::dvec3& x,
                                  const glm::dvec3& w) const;

  // The whole integral along a view ray of the medium, with a relative error of `tolerance`.
  [[nodiscard]] glm::dvec3 airlight(const MediumIndex& medium, const ViewRayMedium<double>& ray,
                                    double tolerance) const;

 private:
  // What each group scatters along w where nothing stands in its way, and the middle of where that
  // comes from.
  [[nodiscard]] std::vector<DistantLight> scattered_along(const glm::dvec3& w) const;
  [[nodiscard]] glm::dvec3 sum(const MediumIndex& medium, const glm::dvec3& x,
                               std::span<const DistantLight> scattered) const;

  double anisotropy_;
  double attenuation_;  // by the fog
  std::vector<LightGroup> groups_;
};

}  // namespace brume
