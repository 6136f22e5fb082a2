#include "core/transport/average_depth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace brume {
namespace {

// By the trapezoidal rule over ln s, which is analytic and bounded up to pi / 2 from the real axis:
// with steps of h its error is exp(-pi^2 / h) of what the integrand is there.
template <class Real>
Real average_depth_of_ellipsoid(const GaussianTerm<Real>& g, const Vec3<Real>& p) {
  constexpr Real step = sizeof(Real) == 4 ? Real(0.6) : Real(0.3);
  // The tails, beyond ln s from both ends of what matters: the integrand decays as s, and as
  // s^(-1/2).
  constexpr Real tail = sizeof(Real) == 4 ? Real(14) : Real(34);
  constexpr Real negligible = sizeof(Real) == 4 ? Real(30) : Real(80);
  // In greatest radii.
  const Vec3<Real> q = g.a * ((p - g.b) * g.ellipsoid->axes);
  const Vec3<Real> rate = Real(1) / (g.ellipsoid->stretch * g.ellipsoid->stretch);
  const Vec3<Real> u2 = rate * q * q;
  const Real begin = -std::log1p(u2.x + u2.y + u2.z) - tail;
  const Real end = std::log(std::max({rate.x, rate.y, rate.z})) + 2 * tail;
  const double ratio = std::exp(static_cast<double>(step));
  double next = std::exp(static_cast<double>(begin));
  Real sum = 0;
  for (Real x = begin; x < end; x += step) {
    const auto s = static_cast<Real>(next);
    next *= ratio;
    const Vec3<Real> r = rate + s;
    const Real exponent = s * (u2.x / r.x + u2.y / r.y + u2.z / r.z);
    if (exponent > negligible) break;  // and it grows
    // Their product would overflow.
    const Real root = std::sqrt(r.x) * std::sqrt(r.y) * std::sqrt(r.z);
    sum += s / root * std::exp(-exponent);
  }
  return g.c / g.a * Real(0.25) / std::numbers::inv_sqrtpi_v<Real> * step * sum;
}

}  // namespace

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
  if (g.ellipsoid) return average_depth_of_ellipsoid(g, p);
  return g.c / g.a * unit_average_depth(g.a * glm::length(p - g.b));
}

double average_depth(const Medium& medium, double far, const glm::dvec3& p) {
  double sum = medium.homogeneous_density() * far;
  const GaussianTerms<double> terms(medium);
  for (const GaussianTerm<double>& g : terms.all()) sum += average_depth(g, p);
  return sum;
}

#define BRUME_AVERAGE_DEPTH(Real)         \
  template Real unit_average_depth(Real); \
  template Real average_depth(const GaussianTerm<Real>&, const Vec3<Real>&);
BRUME_AVERAGE_DEPTH(double)
BRUME_AVERAGE_DEPTH(float)
#undef BRUME_AVERAGE_DEPTH

}  // namespace brume
