#include "core/transport/spot_falloff.h"

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

SpotFalloff::SpotFalloff(const std::optional<SpotCone>& cone) {
  if (!cone) return;
  axis_ = unit_direction(cone->direction, {0.0, -1.0, 0.0});
  dark_cosine_ = std::cos(glm::radians(cone->outer_angle));
  const double difference = std::cos(glm::radians(cone->inner_angle)) - dark_cosine_;
  per_cosine_ = 1.0 / std::max(difference, min_cosine_difference);
}

double SpotFalloff::at(const glm::dvec3& w) const {
  if (is_isotropic()) return 1.0;
  const double share = std::clamp((glm::dot(w, axis_) - dark_cosine_) * per_cosine_, 0.0, 1.0);
  return share * share;
}

std::array<double, 4> SpotFalloff::edges(const glm::dvec3& light, const glm::dvec3& origin,
                                         const glm::dvec3& w) const {
  std::array<double, 4> found{infinity, infinity, infinity, infinity};
  if (is_isotropic()) return found;
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
