#include "core/transport/closed_form_airlight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math/quadrature.h"
#include "core/transport/phase_function.h"

namespace brume {

template <class Real>
PointScattering<Real> point_scattering(const GaussianTerm<Real>& g, const LineProfile<Real>& line,
                                       Real d, ScatterPoint point) {
  const Real t =
      point == ScatterPoint::mean ? truncated_mean(line, d) : std::clamp(line.t0, Real(0), d);
  return {t, optical_depth(g, line, d), optical_depth(g, line, t)};
}

template <class Real>
Real gaussian_airlight(const GaussianTerm<Real>& g, const Vec3<Real>& eye, const Vec3<Real>& w,
                       Real d, const Vec3<Real>& light, const PointLightRay<Real>& path,
                       Real frozen, Real anisotropy, ScatterPoint point) {
  return gaussian_airlight(g, point_scattering(g, line_profile(g, eye, w), d, point), eye, w, light,
                           path, frozen, anisotropy);
}

template <class Real>
Real gaussian_airlight(const GaussianTerm<Real>& g, const PointScattering<Real>& scattering,
                       const Vec3<Real>& eye, const Vec3<Real>& w, const Vec3<Real>& light,
                       const PointLightRay<Real>& path, Real frozen, Real anisotropy) {
  const auto [t, depth, depth_to_point] = scattering;
  if (!(depth > 0)) return 0;
  const Real self_depth = depth_to_point + optical_depth(g, light, eye + t * w);
  const Real phase = anisotropy != 0 ? henyey_greenstein(path.cos_theta(t), anisotropy) : Real(1);
  return phase * depth * std::exp(-(frozen + self_depth)) /
         (4 * std::numbers::pi_v<Real> * path.distance2(t));
}

#define BRUME_GAUSSIAN_AIRLIGHT(Real)                                                              \
  template PointScattering<Real> point_scattering(const GaussianTerm<Real>&,                       \
                                                  const LineProfile<Real>&, Real, ScatterPoint);   \
  template Real gaussian_airlight(const GaussianTerm<Real>&, const Vec3<Real>&, const Vec3<Real>&, \
                                  Real, const Vec3<Real>&, const PointLightRay<Real>&, Real, Real, \
                                  ScatterPoint);                                                   \
  template Real gaussian_airlight(const GaussianTerm<Real>&, const PointScattering<Real>&,         \
                                  const Vec3<Real>&, const Vec3<Real>&, const Vec3<Real>&,         \
                                  const PointLightRay<Real>&, Real, Real);
BRUME_GAUSSIAN_AIRLIGHT(double)
BRUME_GAUSSIAN_AIRLIGHT(float)
#undef BRUME_GAUSSIAN_AIRLIGHT

template <class Real>
Real homogeneous_airlight(Real b0, const PointLightRay<Real>& path, Real d, Real anisotropy) {
  if (!(b0 > 0) || !(d > 0)) return 0;
  // Past `reach` the path eye -> point -> light is so much longer than the shortest one that
  // nothing is left: exp(-40) in double, exp(-20) in float.
  const Real start = path.path_length(0);
  const Real longest = start + (sizeof(Real) == 4 ? Real(20) : Real(40)) / b0;
  const Real reach =
      (longest - start) * (longest + start) / (2 * std::max(longest - path.ts, longest - start));
  const EquiAngular<Real> angular(path, std::min(d, reach));

  const auto transmittance = [&](Real x) {
    const Real t = angular.t(angular.span * x);
    const Real phase = anisotropy != 0 ? henyey_greenstein(path.cos_theta(t), anisotropy) : Real(1);
    return phase * std::exp(-b0 * (t + path.path_length(t) - start));
  };
  const std::array<Real, 2> all = {0, 1};
  const Real tolerance = sizeof(Real) == 4 ? Real(1e-5) : Real(1e-11);
  const Real mean = integrate<Real>(transmittance, all, tolerance).value;
  return b0 * std::exp(-b0 * start) * mean * (angular.span / path.h) /
         (4 * std::numbers::pi_v<Real>);
}

template double homogeneous_airlight(double, const PointLightRay<double>&, double, double);
template float homogeneous_airlight(float, const PointLightRay<float>&, float, float);

}  // namespace brume
