#include "core/medium/gaussian_covariance.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace brume {

glm::dmat3 covariance_of(const Gaussian& g) {
  const double variance = 0.5 * g.radius * g.radius;
  if (g.is_ball()) return glm::dmat3(variance);
  const glm::dmat3 axes = glm::mat3_cast(g.shape.rotation);
  glm::dmat3 scaled = axes;
  for (int k = 0; k < 3; ++k) scaled[k] *= variance * g.shape.stretch[k] * g.shape.stretch[k];
  return scaled * glm::transpose(axes);
}

void set_covariance(Gaussian& gaussian, const glm::dmat3& s) {
  // It is L L^T by Cholesky: L makes it of the ball of variance 1.
  const double tiny = 1e-30 * (s[0][0] + s[1][1] + s[2][2]);
  const double xx = std::sqrt(std::max(s[0][0], tiny));
  const double yx = s[0][1] / xx;
  const double zx = s[0][2] / xx;
  const double yy = std::sqrt(std::max(s[1][1] - yx * yx, tiny));
  const double zy = (s[1][2] - zx * yx) / yy;
  const double zz = std::sqrt(std::max(s[2][2] - zx * zx - zy * zy, tiny));
  gaussian.radius = std::numbers::sqrt2;
  gaussian.shape = {};
  transform(gaussian, {{xx, yx, zx}, {0.0, yy, zy}, {0.0, 0.0, zz}});
}

}  // namespace brume
