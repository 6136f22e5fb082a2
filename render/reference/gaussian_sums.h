#pragma once

#include <vector>

#include "core/transport/optical_depth.h"

namespace brume {

// Sums over Gaussians at one point, where the reference spends its time: plain in float, in
// SIMD over the Gaussians in double (relative error about 1e-15 per term).

// Gaussians as one view ray from t = 0 crosses them.
template <class Real>
class Crossings {
 public:
  // Ignores a Gaussian that is nothing on the whole line.
  void add(const GaussianTerm<Real>& g, const LineProfile<Real>& line);
  // To be called once, after the last add().
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
    Real scale;  // half the depth of the whole line
    Real start;  // erfc(|a t0|): the start of the ray
  };
  [[nodiscard]] const std::vector<Crossing>& all() const { return all_; }

 private:
  std::vector<Crossing> all_;
  std::vector<Real> a_, t0_, peak_, scale_, start_;
};

// Gaussians around a light, for depths from the light to points.
template <class Real>
class GaussiansAroundLight {
 public:
  explicit GaussiansAroundLight(const Vec3<Real>& light) : light_(light) {}

  // A path farther than `reach` from the centre leaves the Gaussian out.
  void add(const GaussianTerm<Real>& g, Real reach);
  void finish();

  // Depth of the Gaussians from the light along the unit vector u over [0, r].
  [[nodiscard]] Real depth(const Vec3<Real>& u, Real r) const;

 private:
  Vec3<Real> light_;
  std::vector<Real> x_, y_, z_;  // centres relative to the light
  std::vector<Real> a_, scale_, reach2_;
};

extern template class Crossings<double>;
extern template class Crossings<float>;
extern template class GaussiansAroundLight<double>;
extern template class GaussiansAroundLight<float>;

}  // namespace brume
