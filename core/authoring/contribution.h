#pragma once

#include <limits>
#include <vector>

#include "core/medium/medium.h"

namespace brume {

// What one Gaussian does to a view ray.
struct Contribution {
  std::size_t index = 0;       // in the medium
  double optical_depth = 0.0;  // of this Gaussian alone on the ray
  double share = 0.0;  // of a unit light from behind everything, what it takes away, in [0, 1]
};

// The Gaussians on a ray (unit direction) as far as `distance` [u], those that take most from it
// first. Each is treated as if it stood alone at its mean on the ray, with what is nearer before
// it. Gaussians whose optical depth is below `least` are left out.
std::vector<Contribution> contributions(const Medium& medium, const glm::dvec3& eye,
                                        const glm::dvec3& direction,
                                        double distance = std::numeric_limits<double>::infinity(),
                                        double least = 1e-3);

}  // namespace brume
