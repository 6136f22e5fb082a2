#include "core/authoring/paintbrush.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "core/math/basis.h"

namespace brume {

double jitter_factor(double jitter, RandomSource& random) {
  return jitter > 0.0 ? std::exp2(jitter * (2.0 * random.uniform() - 1.0)) : 1.0;
}

Gaussian stretched(const Gaussian& ball, const glm::dvec3& direction, double stretch) {
  const Basis plane = make_basis(direction);
  const glm::dmat3 axes(plane.u, plane.v, direction);
  Gaussian result = ball;
  result.set_radii(ball.radius * glm::dvec3(1.0, 1.0, stretch),
                   glm::normalize(glm::quat_cast(axes)));
  return result;
}

Gaussian PaintStroke::dab(const glm::dvec3& center, double offset, double size, double strength) {
  const double edge = 1.0 - brush_.falloff * offset * offset * (3.0 - 2.0 * offset);
  const double radius = brush_.radius * size * jitter_factor(brush_.jitter, random_);
  const double density = brush_.density * brush_.flow * strength * edge;
  return {center, radius, density * jitter_factor(brush_.jitter, random_)};
}

std::vector<Gaussian> PaintStroke::extend(const glm::dvec3& point, double size, double strength) {
  const double step = std::max(brush_.spacing, 0.05) * brush_.stretch * brush_.radius * size;
  const glm::dvec3 way = last_ ? point - *last_ : glm::dvec3(0.0);
  const double length = glm::length(way);
  if (!last_ || !(length <= max_steps * step)) {
    last_ = point;
    // From a ball to an ellipsoid, which reaches farther back.
    distance_to_next_ = 0.5 * (1.0 + 1.0 / brush_.stretch) * step;
    return {dab(point, 0.0, size, strength)};
  }
  std::vector<Gaussian> gaussians;
  if (length == 0.0) return gaussians;
  const glm::dvec3 direction = way / length;
  const Basis plane = make_basis(direction);
  double distance = distance_to_next_;
  for (; distance <= length; distance += step) {
    const glm::dvec2 in_disc = random_.in_disc();
    const glm::dvec2 offset = brush_.scatter * brush_.radius * size * in_disc;
    const glm::dvec3 center =
        *last_ + distance * direction + offset.x * plane.u + offset.y * plane.v;
    gaussians.push_back(
        stretched(dab(center, glm::length(in_disc), size, strength), direction, brush_.stretch));
  }
  distance_to_next_ = distance - length;
  last_ = point;
  return gaussians;
}

}  // namespace brume
