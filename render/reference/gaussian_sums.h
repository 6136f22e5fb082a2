#pragma once

#include <vector>

#include "core/transport/optical_depth.h"

namespace brume {

// Sums over Gaussians at one point, the hot loop of the reference: scalar in float, SIMD over
// Gaussians in double (relative error about 1e-15 per term).

// Gaussians crossed by a view ray from t = 0.
template <class Real>
class Crossings {
 public:
  // Ignores a Gaussian that vanishes on the whole line.
  void add(const GaussianTerm<Real>& g, const LineProfile<Real>& line);
  // Call once, after the last add().
  void finish();

  struct Sums {
    Real density;  // of the Gaussians at t [1/u]
    Real depth;    // over [0, t]
  };
  // t may be +inf.
  [[nodiscard]] Sums at(Real t) const;

  struct Crossing {
    Real a, t0;
    Real peak;   // density at t0 [1/u]
    Real scale;  // half the optical depth of the whole line
    Real start;  // erfc(|a t0|), for the ray's start
  };
  [[nodiscard]] const std::vector<Crossing>& all() const { return all_; }

 private:
  std::vector<Crossing> all_;
  std::vector<Real> a_, t0_, peak_, scale_, start_;
};

// Gaussians relative to a light, for optical depths from it.
template <class Real>
class GaussiansAroundLight {
 public:
  explicit GaussiansAroundLight(const Vec3<Real>& light) : light_(light) {}

  // The Gaussian is culled from paths farther than `cutoff_radius` from its center.
  void add(const GaussianTerm<Real>& g, Real cutoff_radius);
  void finish();

  // Optical depth from the light along the unit vector u over [0, r].
  [[nodiscard]] Real depth(const Vec3<Real>& u, Real r) const;

 private:
  Vec3<Real> light_;
  std::vector<Real> x_, y_, z_;  // centers relative to the light
  std::vector<Real> a_, scale_, cutoff2_;
  // One by one: each in a space of its own.
  struct AroundEllipsoid {
    GaussianTerm<Real> term;
    Real cutoff_in_radii;
  };
  std::vector<AroundEllipsoid> ellipsoids_;
};

extern template class Crossings<double>;
extern template class Crossings<float>;
extern template class GaussiansAroundLight<double>;
extern template class GaussiansAroundLight<float>;

}  // namespace brume
