#pragma once

#include <glm/vec3.hpp>

#include "core/medium/gaussian_term.h"

namespace brume {

// The line integral of a Gaussian c exp(-a^2 |x - b|^2) (eq. 31 of the paper), in double and float,
// with relative accuracy in the tails and for short segments. That of an ellipsoid is the same in
// the space in which it is a ball, W (x - b): a line of direction w passes it as fast as |W w|.

// A Gaussian relative to a line.
template <class Real>
struct LineProfile {
  Real t0;  // parameter of the point of greatest density
  Real e;   // minus the exponent there; of a ball a^2 h^2 for the distance h of the line from the
            // center, computed from the perpendicular vector to avoid cancellation
  Real a;   // the density on the line is c exp(-(e + a^2 (t - t0)^2))
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
double optical_depth(const Gaussian& g, const glm::dvec3& A, const glm::dvec3& B);

// Density-weighted mean parameter of the Gaussian on [0, d].
template <class Real>
Real truncated_mean(const LineProfile<Real>& line, Real d);

// Cutoff radius: any segment farther from the center has an optical depth below eps (rigorous). 0:
// below eps everywhere. Of an ellipsoid that of its greatest radius.
double cutoff_radius(double radius, double density, double eps);

#define BRUME_OPTICAL_DEPTH(Real)                                                                \
  extern template LineProfile<Real> line_profile(const GaussianTerm<Real>&, const Vec3<Real>&,   \
                                                 const Vec3<Real>&);                             \
  extern template Real optical_depth(const GaussianTerm<Real>&, const LineProfile<Real>&, Real); \
  extern template Real optical_depth(const GaussianTerm<Real>&, const Vec3<Real>&,               \
                                     const Vec3<Real>&);                                         \
  extern template Real truncated_mean(const LineProfile<Real>&, Real);
BRUME_OPTICAL_DEPTH(double)
BRUME_OPTICAL_DEPTH(float)
#undef BRUME_OPTICAL_DEPTH

}  // namespace brume
