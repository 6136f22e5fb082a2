#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/medium/gaussian.h"

namespace brume {

// What Gaussian splatting shows: an ellipsoid.
struct Splat {
  glm::dvec3 center{0.0};
  glm::dvec3 deviations{1.0};  // standard deviations along its own axes [u], > 0, finite
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  double depth = 0.0;  // optical depth across the middle of the ball of its volume
};

// The ball of a splat's volume, of radius sqrt(2) (s_0 s_1 s_2)^(1/3).
Gaussian ball_of(const Splat& splat);

// Up to 3 x 3 equal balls that have the mass of that one and the splat's extents, in the sense of
// second moments: exactly along axes at least 1.25 times as long as a ball is wide; a ball is as
// wide as the others, but at least the longest over 1.9. Neighbours are at most two deviations
// apart, so that no gap is seen between them (the sum varies by 1.4%).
std::vector<Gaussian> balls_along(const Splat& splat);

}  // namespace brume
