#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/math/infinity.h"

namespace brume {

// Where a ray is in homogeneous fog [u]; empty: not at all.
struct FogInterval {
  double begin = 0.0;
  double end = infinity;

  // The length of it between two places of the ray.
  [[nodiscard]] double overlap(double first, double last) const {
    return std::max(std::min(end, last) - std::max(begin, first), 0.0);
  }
  // The length of it before a place.
  [[nodiscard]] double before(double t) const { return overlap(0.0, t); }
  [[nodiscard]] bool contains(double t) const { return begin < end && t >= begin && t <= end; }
};

// Where homogeneous fog is: everywhere, or in a ball.
struct FogBall {
  glm::dvec3 center{0.0};
  double radius = infinity;  // [u]

  [[nodiscard]] bool is_endless() const { return radius == infinity; }

  [[nodiscard]] bool contains(const glm::dvec3& x) const {
    return is_endless() || glm::length(x - center) < radius;
  }
  // The interval of a ray from x in the unit direction w within it.
  [[nodiscard]] FogInterval interval(const glm::dvec3& x, const glm::dvec3& w) const {
    if (is_endless()) return {};
    const Chord chord = chord_of(x, w);
    if (!(chord.half > 0.0)) return {0.0, 0.0};
    return {std::max(-chord.half - chord.along, 0.0), std::max(chord.half - chord.along, 0.0)};
  }
  // Length of such a ray within it [u].
  [[nodiscard]] double length(const glm::dvec3& x, const glm::dvec3& w) const {
    if (is_endless()) return infinity;
    const Chord chord = chord_of(x, w);
    return std::clamp(chord.half - chord.along, 0.0, 2.0 * chord.half);
  }
  // The same of its first `distance` [u].
  [[nodiscard]] double length(const glm::dvec3& x, const glm::dvec3& w, double distance) const {
    if (is_endless()) return distance;
    const Chord chord = chord_of(x, w);
    const double up_to_end = std::clamp(chord.half - chord.along, 0.0, 2.0 * chord.half);
    return std::clamp(distance + chord.half + chord.along, 0.0, std::min(up_to_end, distance));
  }
  // The mean of length() over all directions [u].
  [[nodiscard]] double mean_length(const glm::dvec3& x) const {
    const double s = glm::length(x - center) / radius;
    if (s < 1e-4) return radius;
    // Far outside the logarithm cancels.
    if (s > 10.0) return radius / (3.0 * s * s) * (1.0 + 0.2 / (s * s));
    const double gap = std::abs(1.0 - s);
    return 0.5 * radius *
           (1.0 + (gap > 0.0 ? (1.0 - s * s) / (2.0 * s) * std::log((1.0 + s) / gap) : 0.0));
  }

  bool operator==(const FogBall&) const = default;

 private:
  // The line of a ray has a part within: half its length, and the way from its middle to the
  // ray's start.
  struct Chord {
    double half, along;
  };
  [[nodiscard]] Chord chord_of(const glm::dvec3& x, const glm::dvec3& w) const {
    const glm::dvec3 q = x - center;
    const double along = glm::dot(q, w);
    const double square = along * along + radius * radius - glm::dot(q, q);
    return {square > 0.0 ? std::sqrt(square) : 0.0, along};
  }
};

// How far around a place fog of density b0 > 0 [1/u] scatters light so that it comes back there:
// some mean free paths (in dense fog alone, with one 15% of the light of all orders is missing), or
// to its end [u].
inline double scattering_reach(double b0, const FogBall& ball, double mean_free_paths = 4.0) {
  return std::min(mean_free_paths / b0, ball.radius);
}

}  // namespace brume
