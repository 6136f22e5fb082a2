#include "core/io/gaussians/splat_output.h"

#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "core/math/srgb.h"
#include "core/number_domain.h"

namespace brume {

glm::dvec3 sh_color(const Gaussian& gaussian, const SplatOutput& output) {
  return sh_of_albedo(gaussian.optics.albedo.value_or(output.albedo));
}

double opacity_of_depth(double depth) {
  return -std::expm1(-depth);
}

namespace {

constexpr double y_00 = 0.5 * std::numbers::inv_sqrtpi;

}  // namespace

glm::dvec3 sh_of_albedo(const glm::dvec3& albedo) {
  glm::dvec3 coefficient;
  for (int c = 0; c < 3; ++c) coefficient[c] = (srgb_encoded(albedo[c]) - 0.5) / y_00;
  return coefficient;
}

glm::dvec3 albedo_of_sh(const glm::dvec3& coefficient, bool is_linear) {
  glm::dvec3 albedo = glm::clamp(0.5 + y_00 * coefficient, 0.0, 1.0);
  for (int c = 0; c < 3 && !is_linear; ++c) albedo[c] = srgb_decoded(albedo[c]);
  return glm::max(albedo, domain::albedo.min_value);
}

}  // namespace brume
