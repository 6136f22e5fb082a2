#pragma once

#include <glm/mat3x3.hpp>

#include "brume/gaussian.h"

namespace brume {

// R diag(radii^2) R^T / 2 for the rotation R [u^2].
glm::dmat3 covariance_of(const Gaussian& gaussian);

// Gives a Gaussian the radii and the rotation of a covariance; elongations beyond the limit are cut
// off.
void set_covariance(Gaussian& gaussian, const glm::dmat3& covariance);

}  // namespace brume
