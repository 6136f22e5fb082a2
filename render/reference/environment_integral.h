#pragma once

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
  // sphere is taken in steps whose error is about `tolerance`, relative.
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
  double anisotropy_;
  double attenuation_;  // by the fog
  std::vector<DistantLight> lights_;
};

}  // namespace brume
