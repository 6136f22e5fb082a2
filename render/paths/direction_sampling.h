#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>

#include "core/math/basis.h"
#include "render/paths/path_random.h"

namespace brume {

// The unit direction at an angle from the unit vector `axis`, at a uniform azimuth.
inline glm::dvec3 direction_around(const glm::dvec3& axis, double cos_theta, PathRandom& random) {
  const double sine = std::sqrt(std::max(0.0, 1.0 - cos_theta * cos_theta));
  const double phi = 2.0 * std::numbers::pi * random.uniform();
  const Basis basis = make_basis(axis);
  return sine * std::cos(phi) * basis.u + sine * std::sin(phi) * basis.v + cos_theta * axis;
}

}  // namespace brume
