#pragma once

#include <limits>
#include <vector>

#include "core/scene/scene.h"

namespace brume {

// What one Gaussian does to a view ray.
struct Contribution {
  std::size_t index = 0;       // in the medium
  double optical_depth = 0.0;  // of this Gaussian alone on the ray
  double share = 0.0;     // of a unit light from behind everything, what it takes away, in [0, 1]
  double before = 0.0;    // optical depth of the Gaussians before it
  double distance = 0.0;  // of its mean on the ray, from the eye [u]
};

// The Gaussians on a ray (unit direction) as far as `distance` [u], those that take most from it
// first. Each is treated as if it stood alone at its mean on the ray, with what is nearer before
// it. Gaussians whose optical depth is below `least` are left out.
std::vector<Contribution> contributions(const Medium& medium, const glm::dvec3& eye,
                                        const glm::dvec3& direction,
                                        double distance = std::numeric_limits<double>::infinity(),
                                        double least = 1e-3);

// What the Gaussian of a contribution scatters to the eye from one light: RGB radiance. The light
// is taken at its mean on the ray, after what the whole medium, b0 included, takes away on both
// ways; surfaces are not looked at.
glm::dvec3 scattered_radiance(const Scene& scene, const Contribution& contribution,
                              const glm::dvec3& eye, const glm::dvec3& direction,
                              const PointLight& light);

}  // namespace brume
