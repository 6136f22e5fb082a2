#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace brume {

// The view rays of the pixels of one tile: input of every airlight method. They start at the eye or
// at offsets from it; then they are parallel, and the offsets across them.
struct TileRays {
  glm::dvec3 eye{0.0};
  std::span<const glm::dvec3> directions;  // unit
  std::span<const double> lengths;         // to the surface [u], or +inf
  std::size_t tile = 0;                    // index on the film
  std::span<const glm::vec2> positions{};  // in the tile, in [0, 1]^2
  std::span<const glm::dvec3> offsets{};   // of each ray [u]; empty: they start at the eye

  [[nodiscard]] glm::dvec3 origin(std::size_t k) const {
    return offsets.empty() ? eye : eye + offsets[k];
  }
};

// A cone that contains all rays of a tile; of parallel rays a cylinder.
struct TileCone {
  glm::dvec3 eye{0.0};      // of parallel rays: where the axis starts
  glm::dvec3 center{0.0};   // unit
  double spread = 0.0;      // maximum distance of a ray from the axis, at distance 1
  double max_length = 0.0;  // [u], or +inf
  double width = 0.0;       // maximum distance of a parallel ray from the axis [u]

  // Parameter and distance at which the nearest ray of the cone passes a point relative to the eye
  // [u]. Behind the eye: of the axis, as t is of parallel rays.
  struct Pass {
    double t = 0.0;
    double h = 0.0;
  };
  [[nodiscard]] Pass nearest_pass(const glm::dvec3& q) const {
    const double t = glm::dot(q, center);
    const double h = std::max(glm::length(q - t * center) - spread * std::max(t, 0.0) - width, 0.0);
    if (!(t > 0.0) || width > 0.0) return {t, h};
    return {std::sqrt(std::max(glm::dot(q, q) - h * h, t * t)), h};
  }
  // Whether rays of the cone may touch a ball.
  [[nodiscard]] bool touches(const glm::dvec3& ball, double radius) const {
    const glm::dvec3 q = ball - eye;
    const double t = glm::dot(q, center);
    if (t > max_length + radius) return false;
    if (t <= 0.0) return glm::dot(q, q) <= radius * radius;
    return nearest_pass(q).h <= radius;
  }
};

struct TileAirlight {
  std::span<glm::vec3> airlight;  // RGB radiance
  std::span<double> depths;       // T(v, p), b0 included; +inf possible
};

}  // namespace brume
