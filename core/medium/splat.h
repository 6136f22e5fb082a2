#pragma once

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "brume/gaussian.h"
#include "brume/splat.h"

namespace brume {

// The radiance of a splat by direction: RGB coefficients of the real spherical harmonics of bands
// 0 to 3, as sh_basis() has them, at the direction from the eye to the splat. Their sum is the
// color.
using SplatColor = std::array<glm::vec3, 16>;

// A splat as Gaussian splatting stores it: an ellipsoid that is as opaque from every side. Files
// have opacity = 1 - exp(-depth).
struct Splat {
  glm::dvec3 center{0.0};
  glm::dvec3 deviations{1.0};  // standard deviations along its own axes [u], >= 0, one > 0, finite
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  double depth = 0.0;  // optical depth through the center, >= 0
  std::optional<glm::dvec3> albedo{};
};

// The rotation of a quaternion of any length; none where it has no direction.
glm::dquat unit_rotation(const glm::dquat& quaternion);

// The shortest or longest radius of a Gaussian, or the mean one [u].
double radius_along(const Gaussian& gaussian, OpacityAlong along);

// Optical depth of a Gaussian's density through its center along that radius:
// sqrt(pi) density radius.
double depth_along(const Gaussian& gaussian, OpacityAlong along);
// Sets the density.
void set_depth_along(Gaussian& gaussian, double depth, OpacityAlong along);

// The ellipsoid of a splat, of radii sqrt(2) times the deviations, that along one of them is as
// deep. Along the mean radius, it has the mass of the ball of its volume that is as deep. Radii
// below limits::min_stretch of the greatest become as much.
Gaussian gaussian_of(const Splat& splat, OpacityAlong along = OpacityAlong::mean);

// Turns a Gaussian by half about z around the origin: from y down, as captures have it, to y up.
void turn_half(Gaussian& gaussian);
// Turns a Gaussian about x around the origin, from z up to y up.
void turn_z_up(Gaussian& gaussian);

// The inverse of gaussian_of(), but for what the Gaussian has besides density and shape.
Splat splat_of(const Gaussian& gaussian, OpacityAlong along = OpacityAlong::mean);

}  // namespace brume
