#include "core/io/gaussians/splat_output.h"

#include <cmath>
#include <numbers>

#include "core/math/srgb.h"

namespace brume {

glm::dvec3 sh_color(const Gaussian& gaussian, const SplatOutput& output) {
  constexpr double y_00 = 0.5 * std::numbers::inv_sqrtpi;
  const glm::dvec3 albedo = gaussian.optics.albedo.value_or(output.albedo);
  glm::dvec3 coefficient;
  for (int c = 0; c < 3; ++c) coefficient[c] = (srgb_encoded(albedo[c]) - 0.5) / y_00;
  return coefficient;
}

double opacity_of_depth(double depth) {
  return -std::expm1(-depth);
}

}  // namespace brume
