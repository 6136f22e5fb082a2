#pragma once

#include "core/transport/light_path.h"

namespace brume {

// Where on the view ray the light of a Gaussian is taken.
enum class ScatterPoint {
  projection,  // the projection of its centre, clamped to the segment: the paper's
  mean,        // its mean on the segment, weighted by density: right where a surface cuts it
};

// A Gaussian on the view ray as one point x_i = v + t w.
template <class Real>
struct PointScattering {
  Real t;               // [u]
  Real depth;           // T_i(v, p)
  Real depth_to_point;  // T_i(v, x_i)
};
template <class Real>
PointScattering<Real> point_scattering(const GaussianTerm<Real>& g, const LineProfile<Real>& line,
                                       Real d, ScatterPoint point = ScatterPoint::projection);

// The paper's airlight of one Gaussian i along a view ray (eq. 16), per unit of radiant
// intensity [1/u^2]:
//
//   L_i = exp(-(frozen + T_i(s, x_i) + T_i(v, x_i))) / (4 pi |x_i - s|^2) * T_i(v, p)
//
// x_i on the segment [0, d] is point_scattering()'s; `frozen` is the optical depth of the other
// Gaussians and b0 along the fixed path s -> b_i -> v, that is Tbar_i(s, b_i) + Tbar_i(v, b_i). The
// paper's factors f0 and f1 multiply exp(+T) by exp(-T); here all depths are summed in one
// exponent, which cannot overflow.
//
// With an anisotropy, henyey_greenstein() at x_i is a factor.
//
// eye, light and g.b in one frame [u]; w unit; d >= 0 or +inf.
template <class Real>
Real gaussian_airlight(const GaussianTerm<Real>& g, const Vec3<Real>& eye, const Vec3<Real>& w,
                       Real d, const Vec3<Real>& light, const PointLightRay<Real>& path,
                       Real frozen, Real anisotropy = 0,
                       ScatterPoint point = ScatterPoint::projection);

// The same where point_scattering() is known, of a view ray that noise bends.
template <class Real>
Real gaussian_airlight(const GaussianTerm<Real>& g, const PointScattering<Real>& scattering,
                       const Vec3<Real>& eye, const Vec3<Real>& w, const Vec3<Real>& light,
                       const PointLightRay<Real>& path, Real frozen, Real anisotropy);

#define BRUME_GAUSSIAN_AIRLIGHT(Real)                                                             \
  extern template PointScattering<Real> point_scattering(                                         \
      const GaussianTerm<Real>&, const LineProfile<Real>&, Real, ScatterPoint);                   \
  extern template Real gaussian_airlight(const GaussianTerm<Real>&, const Vec3<Real>&,            \
                                         const Vec3<Real>&, Real, const Vec3<Real>&,              \
                                         const PointLightRay<Real>&, Real, Real, ScatterPoint);   \
  extern template Real gaussian_airlight(const GaussianTerm<Real>&, const PointScattering<Real>&, \
                                         const Vec3<Real>&, const Vec3<Real>&, const Vec3<Real>&, \
                                         const PointLightRay<Real>&, Real, Real);
BRUME_GAUSSIAN_AIRLIGHT(double)
BRUME_GAUSSIAN_AIRLIGHT(float)
#undef BRUME_GAUSSIAN_AIRLIGHT

// Airlight of a homogeneous medium (the paper's eq. 17 to 19, the model of Sun et al. 2005):
//   b0 / (4 pi) * integral over t in [0, d] of exp(-b0 (t + r(t))) / r(t)^2 dt,  per unit of
// radiant intensity; r(t) is the distance from the light [1/u^2]. b0 >= 0 [1/u], d may be +inf.
// With an anisotropy the integrand has henyey_greenstein() as a factor.
//
// Computed by adaptive quadrature in the equi-angular variable, which has none of the
// singularities of the published closed form (eq. 20: 0/0 along the light's direction, overflow
// for a light behind the eye). Relative error at most 1e-10 (double), 1e-5 (float).
template <class Real>
Real homogeneous_airlight(Real b0, const PointLightRay<Real>& path, Real d, Real anisotropy = 0);

extern template double homogeneous_airlight(double, const PointLightRay<double>&, double, double);
extern template float homogeneous_airlight(float, const PointLightRay<float>&, float, float);

}  // namespace brume
