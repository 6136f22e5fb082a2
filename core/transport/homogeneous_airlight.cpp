#include "core/transport/homogeneous_airlight.h"

#include <array>
#include <numbers>

#include "core/math/quadrature.h"
#include "core/transport/phase_function.h"

namespace brume {

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
