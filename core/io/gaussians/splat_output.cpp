#include "core/io/gaussians/splat_output.h"

#include <cmath>

#include "core/io/gaussians/splat_color.h"

namespace brume {

glm::dvec3 sh_color(const Gaussian& gaussian, const SplatOutput& output) {
  return sh_of_albedo(gaussian.optics.albedo.value_or(output.albedo));
}

double opacity_of_depth(double depth) {
  return -std::expm1(-depth);
}

}  // namespace brume
