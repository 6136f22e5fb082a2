#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "brume/gaussian.h"

namespace brume {

// An ellipsoid of Gaussian splatting.
struct Splat {
  glm::dvec3 center{0.0};
  glm::dvec3 deviations{1.0};  // standard deviations along its own axes [u], > 0, finite
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  double depth = 0.0;  // optical depth through the center of the sphere of equal volume
};

// The sphere of a splat's volume, of radius sqrt(2) (s_0 s_1 s_2)^(1/3).
Gaussian equivalent_sphere(const Splat& splat);

// Approximates a splat by up to 3 x 3 equal spheres of its mass and second moments: exact along
// axes at least 1.25 times as long as a sphere is wide; a sphere is as wide as the shorter axes,
// but at least the longest / 1.9. Neighbours are at most two deviations apart, so no gaps are
// visible (the sum varies by 1.4%).
std::vector<Gaussian> sphere_approximation(const Splat& splat);
inline constexpr std::size_t max_spheres = 9;

}  // namespace brume
