#include "core/transport/gaussian_airlight.h"

#include <numbers>

#include "core/transport/phase_function.h"

namespace brume {

template <class Real>
Real gaussian_airlight(const GaussianTerm<Real>& g, const Vec3<Real>& eye, const Vec3<Real>& w,
                       Real d, const Vec3<Real>& light, const LightPath<Real>& path, Real frozen,
                       Real anisotropy) {
  const LineProfile<Real> line = line_profile(g, eye, w);
  const Real depth = optical_depth(g, line, d);
  if (!(depth > 0)) return 0;
  const Real t = std::clamp(line.t0, Real(0), d);
  const Real own = optical_depth(g, line, t) + optical_depth(g, light, eye + t * w);
  const Real phase = anisotropy != 0 ? henyey_greenstein(path.cos_turn(t), anisotropy) : Real(1);
  return phase * depth * std::exp(-(frozen + own)) /
         (4 * std::numbers::pi_v<Real> * path.distance2(t));
}

#define BRUME_GAUSSIAN_AIRLIGHT(Real)                                                              \
  template Real gaussian_airlight(const GaussianTerm<Real>&, const Vec3<Real>&, const Vec3<Real>&, \
                                  Real, const Vec3<Real>&, const LightPath<Real>&, Real, Real);
BRUME_GAUSSIAN_AIRLIGHT(double)
BRUME_GAUSSIAN_AIRLIGHT(float)
#undef BRUME_GAUSSIAN_AIRLIGHT

}  // namespace brume
