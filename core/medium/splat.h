#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "brume/gaussian.h"

namespace brume {

// What Gaussian splatting stores: an ellipsoid that is as opaque from every side.
struct Splat {
  glm::dvec3 center{0.0};
  glm::dvec3 deviations{1.0};  // standard deviations along its own axes [u], > 0, finite
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  double depth = 0.0;  // optical depth through the center
};

// The same ellipsoid, of radii sqrt(2) times the deviations, as a medium. An opacity is no density:
// a medium is more opaque along its longer axes, so along one length only it can be as deep as the
// splat. That is its mean radius (s_0 s_1 s_2)^(1/3), and so it has the mass of the ball of its
// volume that is as deep. Radii below limits::min_stretch of the greatest become as much.
Gaussian gaussian_of(const Splat& splat);

}  // namespace brume
