#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/transport/optical_depth.h"

namespace brume {

// A point light relative to a view ray: nearest point at parameter ts, distance h.
//
// In-scattered radiance grows like 1/h and diverges at the light, so h is clamped to h_min (the
// size of the source, or a fraction of the pixel's footprint); falloff is 1 / ((t - ts)^2 + h^2).
template <class Real>
struct PointLightRay {
  Real ts;                // [u]
  Real h;                 // [u], > 0
  Real distance_to_line;  // unclamped h [u]

  PointLightRay(const Vec3<Real>& light, const Vec3<Real>& eye, const Vec3<Real>& w, Real h_min) {
    const Vec3<Real> q = light - eye;
    ts = glm::dot(q, w);
    distance_to_line = glm::length(q - ts * w);
    h = std::max({distance_to_line, h_min, floor(std::abs(ts))});
  }

  // Squared (clamped) distance from the light to the point at t.
  [[nodiscard]] Real distance2(Real t) const { return (t - ts) * (t - ts) + h * h; }

  // Cosine of the scattering angle at t, towards the eye.
  [[nodiscard]] Real cos_theta(Real t) const {
    const Real r = path_length(t);
    return r > 0 ? (ts - t) / r : Real(0);
  }

  // Length of the light's path to t; only the falloff is clamped.
  [[nodiscard]] Real path_length(Real t) const { return std::hypot(t - ts, distance_to_line); }

 private:
  // A light exactly on the ray needs h > 0; radiance before the light depends on h^2 only, so this
  // changes nothing there.
  static Real floor(Real ts) {
    return std::max(ts * (sizeof(Real) == 4 ? Real(1e-6) : Real(1e-12)), Real(1e-30));
  }
};

// Equi-angular parametrisation of a segment [0, d] of a view ray:
//   integral f(t) / distance2(t) dt = integral over phi in [0, span] of f(t(phi)) dphi / h.
template <class Real>
struct EquiAngular {
  PointLightRay<Real> path;
  Real eye2;  // squared distance from the light to the ray's start
  Real span;  // angle subtended at the light [radians]

  // d may be +inf.
  EquiAngular(const PointLightRay<Real>& path_, Real d)
      : path(path_), eye2(path_.distance2(0)), span(angle(d)) {}

  // The angle between the start and the point at t.
  [[nodiscard]] Real angle(Real t) const {
    // By cross and dot product, exact for lights close to the ray.
    if (!std::isfinite(t)) return std::atan2(path.h, -path.ts);
    return std::atan2(path.h * t, eye2 - path.ts * t);
  }

  [[nodiscard]] Real t(Real phi) const {
    const Real s = std::sin(phi);
    return eye2 * s / std::max(path.h * std::cos(phi) + path.ts * s, tiny);
  }

 private:
  static constexpr Real tiny = Real(1e-30);
};

}  // namespace brume
