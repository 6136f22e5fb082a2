#include "core/medium/splat.h"

#include <cmath>
#include <numbers>

#include "core/math/max_component.h"

namespace brume {
namespace {

const double sqrt_pi = 1.0 / std::numbers::inv_sqrtpi;

}  // namespace

glm::dquat unit_rotation(const glm::dquat& quaternion) {
  const double length = glm::length(quaternion);
  return length > 0.0 && std::isfinite(length) ? quaternion / length
                                               : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

double radius_along(const Gaussian& gaussian, OpacityAlong along) {
  switch (along) {
    case OpacityAlong::shortest:
      return min_component(gaussian.radii());
    case OpacityAlong::mean:
      return gaussian.mean_radius();
    case OpacityAlong::longest:
      return gaussian.radius;
  }
  return gaussian.radius;
}

double depth_along(const Gaussian& gaussian, OpacityAlong along) {
  return sqrt_pi * gaussian.density * radius_along(gaussian, along);
}

void set_depth_along(Gaussian& gaussian, double depth, OpacityAlong along) {
  gaussian.density = depth / (sqrt_pi * radius_along(gaussian, along));
}

Gaussian gaussian_of(const Splat& splat, OpacityAlong along) {
  Gaussian g{splat.center};
  g.set_radii(std::numbers::sqrt2 * splat.deviations, splat.rotation);
  set_depth_along(g, splat.depth, along);
  g.optics.albedo = splat.albedo;
  return g;
}

void turn_half(Gaussian& g) {
  g.center = {-g.center.x, -g.center.y, g.center.z};
  if (!g.is_ball()) g.shape.rotation = glm::dquat(0.0, 0.0, 0.0, 1.0) * g.shape.rotation;
}

void turn_z_up(Gaussian& g) {
  constexpr double half = 0.5 * std::numbers::sqrt2;
  g.center = {g.center.x, g.center.z, -g.center.y};
  if (!g.is_ball()) g.shape.rotation = glm::dquat(half, -half, 0.0, 0.0) * g.shape.rotation;
}

Splat splat_of(const Gaussian& gaussian, OpacityAlong along) {
  return {gaussian.center, gaussian.radii() / std::numbers::sqrt2, gaussian.shape.rotation,
          depth_along(gaussian, along)};
}

}  // namespace brume
