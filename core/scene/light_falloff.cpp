#include "core/scene/light_falloff.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/math/infinity.h"
#include "core/math/unit_direction.h"

namespace brume {
namespace {

// Of glTF, which keeps the edge from being infinitely sharp.
constexpr double min_cosine_difference = 1e-3;

}  // namespace

LightFalloff::LightFalloff(const SpotCone& cone) : shape_(Shape::cone) {
  axis_ = unit_direction(cone.direction, {0.0, -1.0, 0.0});
  dark_cosine_ = std::cos(glm::radians(cone.outer_angle));
  const double difference = std::cos(glm::radians(cone.inner_angle)) - dark_cosine_;
  per_cosine_ = 1.0 / std::max(difference, min_cosine_difference);
}

LightFalloff LightFalloff::of_surface(const glm::dvec3& normal, bool two_sided) {
  LightFalloff falloff;
  falloff.axis_ = normal;
  falloff.shape_ = two_sided ? Shape::two_cosines : Shape::cosine;
  return falloff;
}

double LightFalloff::at(const glm::dvec3& w) const {
  const double cosine = glm::dot(w, axis_);
  switch (shape_) {
    case Shape::isotropic:
      return 1.0;
    case Shape::cone: {
      const double share = std::clamp((cosine - dark_cosine_) * per_cosine_, 0.0, 1.0);
      return share * share;
    }
    case Shape::cosine:
      return std::clamp(cosine, 0.0, 1.0);
    case Shape::two_cosines:
      return std::min(std::abs(cosine), 1.0);
  }
  return 1.0;
}

std::array<double, 4> LightFalloff::edges(const glm::dvec3& light, const glm::dvec3& origin,
                                          const glm::dvec3& w) const {
  std::array<double, 4> found{infinity, infinity, infinity, infinity};
  if (is_isotropic()) return found;
  if (shape_ != Shape::cone) {
    const double slope = glm::dot(w, axis_);
    if (slope != 0.0) found[0] = glm::dot(light - origin, axis_) / slope;
    return found;
  }
  // (q axis)^2 = c^2 q q with q = p + s w, s from the point nearest to the light.
  const glm::dvec3 from_light = origin - light;
  const double nearest = -glm::dot(from_light, w);
  const glm::dvec3 p = from_light + nearest * w;
  const double along = glm::dot(w, axis_);
  const double across = glm::dot(p, axis_);
  const double square = glm::dot(p, p);
  std::size_t count = 0;
  for (const double cosine : {dark_cosine_, dark_cosine_ + 1.0 / per_cosine_}) {
    const double a = along * along - cosine * cosine;
    const double b = along * across;
    const double c = across * across - cosine * cosine * square;
    const double root = b * b - a * c;
    if (!(root >= 0.0)) continue;
    // Without cancellation.
    const double sum = -(b + std::copysign(std::sqrt(root), b));
    if (a != 0.0) found[count++] = nearest + sum / a;
    if (sum != 0.0) found[count++] = nearest + c / sum;
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace brume
