#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/transport/optical_depth.h"

namespace brume {

// Where a point light stands to a view ray: the ray passes it at parameter ts and distance h.
//
// Radiance scattered along a ray grows like 1/h and is infinite through the light itself, so a
// light has a least distance: h is never below h_min (the size of the source, or a fraction of
// the pixel's footprint there), and the light falls off with 1 / ((t - ts)^2 + h^2).
template <class Real>
struct LightPath {
  Real ts;   // [u]
  Real h;    // [u], > 0
  Real gap;  // what h would be without the least distance [u]

  LightPath(const Vec3<Real>& light, const Vec3<Real>& eye, const Vec3<Real>& w, Real h_min) {
    const Vec3<Real> q = light - eye;
    ts = glm::dot(q, w);
    gap = glm::length(q - ts * w);
    h = std::max({gap, h_min, floor(std::abs(ts))});
  }

  // The squared distance of the light from the ray's point at t.
  [[nodiscard]] Real distance2(Real t) const { return (t - ts) * (t - ts) + h * h; }

  // The cosine of the angle by which light turns at that point, from the light towards the eye.
  [[nodiscard]] Real cos_turn(Real t) const {
    const Real r = travelled(t);
    return r > 0 ? (ts - t) / r : Real(0);
  }

  // How far light travels to that point: only the falloff has a least distance.
  [[nodiscard]] Real travelled(Real t) const { return std::hypot(t - ts, gap); }

 private:
  // A light exactly on the ray needs some h > 0; what is seen short of the light depends on h
  // only by h^2, so this changes nothing there.
  static Real floor(Real ts) {
    return std::max(ts * (sizeof(Real) == 4 ? Real(1e-6) : Real(1e-12)), Real(1e-30));
  }
};

// The equi-angular parametrisation of a segment [0, d] of a view ray as the light sees it:
// integral f(t) / distance2(t) dt = integral over phi in [0, span] of f(t(phi)) dphi / h.
template <class Real>
struct EquiAngular {
  LightPath<Real> path;
  Real eye2;  // squared distance of the light from the ray's start
  Real span;  // angle between start and end at the light [radians]

  // d may be +inf.
  EquiAngular(const LightPath<Real>& path_, Real d)
      : path(path_), eye2(path_.distance2(0)), span(angle(d)) {}

  // The angle between the start and the point at t.
  [[nodiscard]] Real angle(Real t) const {
    // As cross and dot product, which stay exact when the light is close to the ray.
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
