#pragma once

#include <glm/vec3.hpp>

#include "brume/gaussian.h"

namespace brume {

// The line integral of a Gaussian c exp(-a^2 |x - b|^2) (eq. 31 of the paper), in double and float,
// with relative accuracy in the tails and for short segments.

template <class Real>
using Vec3 = glm::vec<3, Real, glm::defaultp>;

// A Gaussian in the paper's symbols: a = 1 / radius [1/u], c = density [1/u], center b [u].
template <class Real>
struct GaussianTerm {
  Real a = 1;
  Real c = 0;
  Vec3<Real> b{0};

  GaussianTerm() = default;
  GaussianTerm(Real a_, Real c_, const Vec3<Real>& b_) : a(a_), c(c_), b(b_) {}
  explicit GaussianTerm(const Gaussian& g)
      : a(Real(1.0 / g.radius)), c(Real(g.density)), b(Vec3<Real>(g.center)) {}
};

// A Gaussian relative to a line.
template <class Real>
struct LineProfile {
  Real t0;  // parameter of the point nearest to the center
  Real e;   // a^2 h^2 for the distance h of the line from the center, computed from the
            // perpendicular vector to avoid cancellation
};

// `w`: unit up to rounding.
template <class Real>
LineProfile<Real> line_profile(const GaussianTerm<Real>& g, const Vec3<Real>& origin,
                               const Vec3<Real>& w);

// T over t in [0, d], d >= 0 or +inf.
template <class Real>
Real optical_depth(const GaussianTerm<Real>& g, const LineProfile<Real>& line, Real d);

// T_i(A, B): optical depth between two points; 0 if they coincide.
template <class Real>
Real optical_depth(const GaussianTerm<Real>& g, const Vec3<Real>& A, const Vec3<Real>& B);

// Density-weighted mean parameter of the Gaussian on [0, d].
template <class Real>
Real truncated_mean(const GaussianTerm<Real>& g, const LineProfile<Real>& line, Real d);

// Cutoff radius: any segment farther from the center has an optical depth below eps (rigorous). 0:
// below eps everywhere.
double cutoff_radius(double radius, double density, double eps);

// Half angle [radians] of the cone around o -> center that contains every ray from o within
// `cutoff_radius` of the center; pi if o is within it.
double cutoff_cone(const glm::dvec3& center, double cutoff_radius, const glm::dvec3& o);

#define BRUME_OPTICAL_DEPTH(Real)                                                                \
  extern template LineProfile<Real> line_profile(const GaussianTerm<Real>&, const Vec3<Real>&,   \
                                                 const Vec3<Real>&);                             \
  extern template Real optical_depth(const GaussianTerm<Real>&, const LineProfile<Real>&, Real); \
  extern template Real optical_depth(const GaussianTerm<Real>&, const Vec3<Real>&,               \
                                     const Vec3<Real>&);                                         \
  extern template Real truncated_mean(const GaussianTerm<Real>&, const LineProfile<Real>&, Real);
BRUME_OPTICAL_DEPTH(double)
BRUME_OPTICAL_DEPTH(float)
#undef BRUME_OPTICAL_DEPTH

}  // namespace brume
