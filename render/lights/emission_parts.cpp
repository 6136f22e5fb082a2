#include "render/lights/emission_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <iterator>
#include <numbers>

#include "render/geometry/rounding.h"

namespace brume {
namespace {

// Point k of a set that is normally distributed with variance 1 along each axis: an additive
// recurrence (Roberts 2018), transformed as by Box and Muller (1958).
glm::dvec3 normal_point(int k) {
  constexpr double ratio = 1.16730397826141868;  // of the recurrence in 4 dimensions: x^5 = x + 1
  const glm::dvec4 steps =
      1.0 / glm::dvec4(ratio, std::pow(ratio, 2.0), std::pow(ratio, 3.0), std::pow(ratio, 4.0));
  const glm::dvec4 u = glm::fract(0.5 + (k + 1.0) * steps);
  const glm::dvec2 radii = glm::sqrt(-2.0 * glm::log(glm::max(glm::dvec2(u), 1e-12)));
  const glm::dvec2 angles = 2.0 * std::numbers::pi * glm::dvec2(u.z, u.w);
  return {radii.x * std::cos(angles.x), radii.x * std::sin(angles.x), radii.y * std::cos(angles.y)};
}

SurfaceHit hit_through_panes(const RayCaster& surfaces, const glm::dvec3& origin,
                             const glm::dvec3& direction) {
  SurfaceHit hit;
  surfaces.opaque_hits(origin, std::span(&direction, 1), std::span(&hit, 1), 0.0);
  return hit;
}

// The mean over parts and the axes' directions of how far they see, at most `far` [u].
double mean_sight(std::span<const glm::dvec3> parts, const RayCaster& surfaces, double far) {
  double sum = 0.0;
  for (const glm::dvec3& part : parts) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        glm::dvec3 direction(0.0);
        direction[axis] = side;
        const SurfaceHit hit = hit_through_panes(surfaces, part, direction);
        sum += hit ? std::min(hit.distance, far) : far;
      }
    }
  }
  return sum / (6.0 * static_cast<double>(parts.size()));
}

}  // namespace

std::vector<glm::dvec3> emission_parts(std::span<const EmittingGaussian> emitters,
                                       const MediumIndex& medium, int count) {
  double all = 0.0;
  for (const EmittingGaussian& emitter : emitters) all += emitter.weight;
  std::vector<glm::dvec3> parts;
  auto emitter = emitters.begin();
  double sum = emitter->weight;  // up to the emitter
  for (int k = 0; k < count; ++k) {
    while (sum < (k + 0.5) / count * all && std::next(emitter) != emitters.end()) {
      sum += (++emitter)->weight;
    }
    const GaussianTerm<double>& g = medium.gaussians()[emitter->index];
    glm::dvec3 offset = normal_point(k) / (std::numbers::sqrt2 * g.a);
    if (g.ellipsoid) offset = g.ellipsoid->axes * (g.ellipsoid->stretch * offset);
    parts.push_back(g.b + offset);
  }
  return parts;
}

bool are_on_one_side(const glm::dvec3& a, const glm::dvec3& b, const RayCaster& surfaces) {
  constexpr int max_crossings = 64;
  const double length = glm::distance(a, b);
  if (!(length > 0.0)) return true;
  const glm::dvec3 direction = (b - a) / length;
  int count = 0;
  for (double t = 0.0; count < max_crossings; ++count) {
    const glm::dvec3 origin = a + t * direction;
    const SurfaceHit hit = hit_through_panes(surfaces, origin, direction);
    if (!hit || t + hit.distance > length) break;
    t += hit.distance + 2.0 * rounding_at(origin - surfaces.center());
  }
  return count % 2 == 0;
}

std::vector<glm::dvec3> parts_in_the_open(const std::vector<glm::dvec3>& parts,
                                          const RayCaster& surfaces) {
  std::array<std::vector<glm::dvec3>, 2> sides;
  for (const glm::dvec3& part : parts) {
    sides[are_on_one_side(parts.front(), part, surfaces) ? 0 : 1].push_back(part);
  }
  std::ranges::sort(sides, std::ranges::greater(), &std::vector<glm::dvec3>::size);
  const auto& [more, fewer] = sides;
  if (fewer.empty()) return more;
  const double far = glm::length(surfaces.bounds().high - surfaces.bounds().low);
  return mean_sight(more, surfaces, far) < 0.5 * mean_sight(fewer, surfaces, far) ? fewer : more;
}

}  // namespace brume
