#include "core/transport/average_depth.h"

#include <glm/geometric.hpp>
#include <numbers>

namespace brume {

template <class Real>
Real unit_average_depth(Real u) {
  // McCabe's continued fraction of Dawson's integral (Math. Comp. 28, 1974):
  //   D(u) / u = 1 / (1 + 2u^2 - 4u^2 / (3 + 2u^2 - 8u^2 / (5 + 2u^2 - ...))),
  // good for every u, without a division by it. It needs most levels around u = 3 (float) and
  // u = 5 (double).
  constexpr int levels = sizeof(Real) == 4 ? 26 : 60;
  constexpr Real half_sqrt_pi = Real(0.5) / std::numbers::inv_sqrtpi_v<Real>;
  if (u > Real(1e8)) return half_sqrt_pi / (2 * u) / u;  // where u^2 might overflow
  const Real x = 2 * u * u;
  Real tail = Real(2 * levels + 1) + x;
  for (int k = levels; k >= 1; --k) tail = Real(2 * k - 1) + x - Real(2 * k) * x / tail;
  return half_sqrt_pi / tail;
}

template <class Real>
Real average_depth(const GaussianTerm<Real>& g, const Vec3<Real>& p) {
  return g.c / g.a * unit_average_depth(g.a * glm::length(p - g.b));
}

double average_depth(const Medium& medium, double far, const glm::dvec3& p) {
  double sum = medium.homogeneous_density() * far;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    sum += average_depth(GaussianTerm<double>(medium.gaussian(i)), p);
  }
  return sum;
}

#define BRUME_AVERAGE_DEPTH(Real)         \
  template Real unit_average_depth(Real); \
  template Real average_depth(const GaussianTerm<Real>&, const Vec3<Real>&);
BRUME_AVERAGE_DEPTH(double)
BRUME_AVERAGE_DEPTH(float)
#undef BRUME_AVERAGE_DEPTH

}  // namespace brume
