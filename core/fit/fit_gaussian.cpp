#include "core/fit/fit_gaussian.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "core/math/max_component.h"

namespace brume {

double FitGaussian::integral() const {
  return c * std::pow(std::numbers::pi, 1.5) / (a * a * a);
}

std::vector<FitGaussian> to_fit_gaussians(const DensityGrid& grid,
                                          std::span<const Gaussian> gaussians) {
  const glm::dmat3 rotation = glm::mat3_cast(grid.rotation);
  std::vector<FitGaussian> result;
  for (const Gaussian& g : gaussians) {
    FitGaussian& fitted = result.emplace_back();
    fitted.b = grid.spacing * grid.to_voxel(g.center);
    fitted.a = 1.0 / g.mean_radius();
    fitted.c = g.density;
    if (!g.is_ball()) fitted.shape = g.mean_radius() / g.radius * (warp(g.shape) * rotation);
  }
  return result;
}

Gaussian to_gaussian(const DensityGrid& grid, const FitGaussian& gaussian) {
  Gaussian result{grid.to_world(gaussian.b / grid.spacing), 1.0 / gaussian.a, gaussian.c};
  if (gaussian.shape != glm::dmat3(1.0)) {
    transform(result, glm::mat3_cast(grid.rotation) * glm::inverse(gaussian.shape));
  }
  return result;
}

FitShape shape_of(std::span<const Gaussian> gaussians) {
  return std::ranges::all_of(gaussians, &Gaussian::is_ball) ? FitShape::ball : FitShape::ellipsoid;
}

glm::dmat3 matrix_change(const FitStep& s) {
  return {{s[4], s[7], s[8]}, {s[7], s[5], s[9]}, {s[8], s[9], s[6]}};
}

FitGaussian moved(const FitGaussian& gaussian, const FitStep& step, FitShape shape) {
  FitStep s = step;
  for (double& number : s) number = std::clamp(number, -0.7, 0.7);
  FitGaussian result = gaussian;
  result.c *= std::exp(s[3]);
  const glm::dvec3 offset(s[0], s[1], s[2]);
  if (shape == FitShape::ball) {
    result.b += offset / gaussian.a;
    result.a *= std::exp(s[4]);
    return result;
  }
  result.b += glm::inverse(gaussian.shape) * offset / gaussian.a;
  // Nearly the exponential, and like it positive: no eigenvalue of the change is beyond its norm.
  glm::dmat3 change = matrix_change(s);
  const double norm = std::sqrt(glm::dot(change[0], change[0]) + glm::dot(change[1], change[1]) +
                                glm::dot(change[2], change[2]));
  change *= std::min(1.0, 1.2 / std::max(norm, 1e-300));
  const glm::dmat3 half = glm::dmat3(1.0) + 0.5 * change;
  result.shape = half * half * gaussian.shape;
  const double scale = std::cbrt(glm::determinant(result.shape));
  result.a *= scale;
  result.shape /= scale;
  return result;
}

std::array<bool, 3> limit(FitGaussian& gaussian, const FitLimits& limits) {
  const double just = (1.0 + 1e-9) * limits.min_radius;
  gaussian.b = glm::clamp(gaussian.b, limits.low, limits.high);
  if (gaussian.shape == glm::dmat3(1.0)) {
    gaussian.a = std::clamp(gaussian.a, 1.0 / limits.max_radius, 1.0 / limits.min_radius);
    const bool is_narrow = gaussian.a * just >= 1.0;
    return {is_narrow, is_narrow, is_narrow};
  }
  Gaussian ellipsoid;
  ellipsoid.radius = 1.0 / gaussian.a;
  transform(ellipsoid, glm::inverse(gaussian.shape));
  glm::dvec3 radii = glm::clamp(ellipsoid.radii(), limits.min_radius, limits.max_radius);
  radii = glm::max(radii, max_component(radii) / max_fitted_elongation);
  gaussian.a = 1.0 / std::cbrt(radii.x * radii.y * radii.z);
  gaussian.shape = glm::transpose(glm::mat3_cast(ellipsoid.shape.rotation));
  for (int k = 0; k < 3; ++k) gaussian.shape[k] /= gaussian.a * radii;
  return {radii.x <= just, radii.y <= just, radii.z <= just};
}

}  // namespace brume
