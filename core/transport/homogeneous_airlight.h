#pragma once

#include "core/transport/light_path.h"

namespace brume {

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
