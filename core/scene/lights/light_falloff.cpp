#include "core/scene/lights/light_falloff.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "core/math/basis.h"
#include "core/math/infinity.h"
#include "core/math/unit_direction.h"
#include "core/scene/lights/photometric_profile.h"

namespace brume {
namespace {

// Keeps the edge finite where the angles are equal. (glTF's 1e-3 would take light from the axis of
// cones narrower than 2.6 degrees.)
constexpr double min_cosine_difference = 1e-9;

// A cone that ends here is full in all directions.
constexpr double beyond_all_versines = 4.0;

// cos(a) - cos(b), of angles in degrees, without cancellation.
double cosine_difference(double a, double b) {
  return 2.0 * std::sin(glm::radians(0.5 * (b + a))) * std::sin(glm::radians(0.5 * (b - a)));
}

// The shortest turn from straight down to a unit direction; to straight up about x.
glm::dquat turn_from_down(const glm::dvec3& direction) {
  // The quaternion of half the turn; its length is 2 cos(half).
  const double w = 1.0 - direction.y;
  if (w < 1e-12) return {0.0, 1.0, 0.0, 0.0};
  const glm::dvec3 axis = glm::cross(glm::dvec3(0.0, -1.0, 0.0), direction);
  return glm::normalize(glm::dquat(w, axis.x, axis.y, axis.z));
}

// The value of a map at a place in its square, [-1, 1]^2.
double in_square(const IntensityMap& map, double x, double y) {
  const auto cell = [&map](double t) {
    const double place = std::clamp(0.5 * (t + 1.0), 0.0, 1.0) * (map.side - 1);
    const int low = std::min(static_cast<int>(place), map.side - 2);
    return std::pair(low, place - low);
  };
  const auto [column, f] = cell(x);
  const auto [row, g] = cell(y);
  const auto value = [&](int dx, int dy) {
    const auto texel = static_cast<std::ptrdiff_t>(row + dy) * map.side + column + dx;
    return static_cast<double>(map.values[static_cast<std::size_t>(texel)]);
  };
  return std::lerp(std::lerp(value(0, 0), value(1, 0), f), std::lerp(value(0, 1), value(1, 1), f),
                   g);
}

}  // namespace

LightFalloff::LightFalloff(const light::Point& point) {
  if (!point.profile.content) return;
  axis_ = {0.0, -1.0, 0.0};
  dark_versine_ = beyond_all_versines;
  per_versine_ = 1.0;
  set_profile(point.profile);
}

LightFalloff::LightFalloff(const light::Spot& spot) : shape_(Shape::cone) {
  axis_ = unit_direction(spot.direction, {0.0, -1.0, 0.0});
  dark_versine_ = cosine_difference(0.0, spot.outer_angle);
  per_versine_ =
      1.0 / std::max(cosine_difference(spot.inner_angle, spot.outer_angle), min_cosine_difference);
  const auto [u, v] = make_basis(axis_);
  azimuth_0_ = u;
  azimuth_90_ = v;
  if (spot.profile.content) set_profile(spot.profile);
}

LightFalloff::LightFalloff(const light::Spot& spot, const BeamPattern& pattern)
    : LightFalloff(spot) {
  shape_ = Shape::picture;
  profile_ = nullptr;
  map_ = pattern.map;
  cotangent_ = 1.0 / beam_tangent(spot);
  turn_about_axis(spot.texture.rotation);
}

void LightFalloff::set_profile(const LightProfile& profile) {
  shape_ = Shape::profile;
  profile_ = profile.content;
  map_ = profile_->map();
  turn_about_axis(profile.rotation);
}

void LightFalloff::turn_about_axis(double degrees) {
  const double turn = glm::radians(degrees);
  const glm::dquat pose = turn_from_down(axis_);
  azimuth_0_ = pose * glm::dvec3(std::cos(turn), 0.0, -std::sin(turn));
  azimuth_90_ = pose * glm::dvec3(-std::sin(turn), 0.0, -std::cos(turn));
}

LightFalloff LightFalloff::of_surface(const glm::dvec3& normal, bool two_sided) {
  LightFalloff falloff;
  falloff.axis_ = normal;
  falloff.shape_ = two_sided ? Shape::two_cosines : Shape::cosine;
  return falloff;
}

double LightFalloff::versine(const glm::dvec3& w) const {
  const glm::dvec3 chord = w - axis_;
  return 0.5 * glm::dot(chord, chord);
}

double LightFalloff::in_cone(const glm::dvec3& w) const {
  const double share = std::clamp((dark_versine_ - versine(w)) * per_versine_, 0.0, 1.0);
  return share * share;
}

double LightFalloff::by_map(const glm::dvec3& w) const {
  if (shape_ != Shape::profile) return at(w);
  const double share = in_cone(w);
  if (!(share > 0.0)) return 0.0;
  const glm::dvec3 q(glm::dot(w, azimuth_0_), glm::dot(w, azimuth_90_), glm::dot(w, axis_));
  const glm::dvec2 place = glm::dvec2(q) / (std::abs(q.x) + std::abs(q.y) + std::abs(q.z));
  if (q.z >= 0.0) return share * in_square(*map_, place.x, place.y);
  return share * in_square(*map_, std::copysign(1.0 - std::abs(place.y), place.x),
                           std::copysign(1.0 - std::abs(place.x), place.y));
}

double LightFalloff::at(const glm::dvec3& w) const {
  const double cosine = glm::dot(w, axis_);
  switch (shape_) {
    case Shape::isotropic:
      return 1.0;
    case Shape::cone:
      return in_cone(w);
    case Shape::cosine:
      return std::clamp(cosine, 0.0, 1.0);
    case Shape::two_cosines:
      return std::min(std::abs(cosine), 1.0);
    case Shape::profile: {
      const double share = in_cone(w);
      if (!(share > 0.0)) return 0.0;
      return share * profile_->at({glm::dot(w, azimuth_0_), glm::dot(w, azimuth_90_), cosine});
    }
    case Shape::picture: {
      const double share = in_cone(w);
      if (!(share > 0.0)) return 0.0;
      const double scale = cotangent_ / cosine;
      return share *
             in_square(*map_, scale * glm::dot(w, azimuth_0_), scale * glm::dot(w, azimuth_90_));
    }
  }
  return 1.0;
}

std::array<double, 4> LightFalloff::edges(const glm::dvec3& light, const glm::dvec3& origin,
                                          const glm::dvec3& w) const {
  std::array<double, 4> found{infinity, infinity, infinity, infinity};
  if (is_isotropic()) return found;
  if (!has_cone()) {
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
  for (const double versine : {dark_versine_, full_versine()}) {
    const double cosine = 1.0 - versine;
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
