#pragma once

#include <limits>
#include <vector>

#include "core/scene/point_lights.h"
#include "core/scene/scene.h"

namespace brume {

// The contribution of one Gaussian to a view ray.
struct Contribution {
  std::size_t index = 0;        // index in the medium
  double optical_depth = 0.0;   // of this Gaussian on the ray
  double fraction = 0.0;        // fraction of unit background light that it absorbs
  double depth_in_front = 0.0;  // optical depth in front of it
  double distance = 0.0;        // from the eye to its mean on the ray
};

// The Gaussians on a ray (unit direction) up to `distance` [u], in descending order of fraction.
// Each is concentrated at its mean on the ray, attenuated by those in front. Gaussians of optical
// depth below `min_optical_depth` are skipped.
std::vector<Contribution> contributions(const Medium& medium, const glm::dvec3& eye,
                                        const glm::dvec3& direction,
                                        double distance = std::numeric_limits<double>::infinity(),
                                        double min_optical_depth = 1e-3);

// RGB radiance that the Gaussian scatters towards the eye from one point light, evaluated at its
// mean on the ray and attenuated by the whole medium including b0 on both segments; surfaces are
// ignored. Of the way to the light, at most `fog_length` [u] passes homogeneous fog.
glm::dvec3 scattered_radiance(const Scene& scene, const Contribution& contribution,
                              const glm::dvec3& eye, const glm::dvec3& direction,
                              const PointLight& light,
                              double fog_length = std::numeric_limits<double>::infinity());

}  // namespace brume
