#include "core/transport/optical_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/math/special_functions.h"

namespace brume {
namespace {

template <class Real>
constexpr Real sqrt_pi = Real(1.77245385090551602729816748334115);

// Half of a Gauss-Legendre rule on [-1, 1] (the nodes come in +- pairs): 4 points are exact to
// float's rounding on the short segments below, 6 to double's.
template <class Real>
struct ShortRule;
template <>
struct ShortRule<float> {
  static constexpr std::array<float, 2> node = {0.3399810435848563f, 0.8611363115940526f};
  static constexpr std::array<float, 2> weight = {0.6521451548625461f, 0.3478548451374538f};
};
template <>
struct ShortRule<double> {
  static constexpr std::array<double, 3> node = {0.2386191860831969086, 0.6612093864662645137,
                                                 0.9324695142031520278};
  static constexpr std::array<double, 3> weight = {0.4679139345726910474, 0.3607615730481386076,
                                                   0.1713244923791703450};
};

// The segment [0, d] in units of the Gaussian, relative to the projection of its centre.
template <class Real>
struct NormalisedSegment {
  Real u0, u1;  // ends
  Real lo, hi;  // min and max of |u0|, |u1|
  Real k;       // length, from d and not from u1 - u0, which would cancel
  bool is_short;
  bool straddles;

  NormalisedSegment(Real a, Real t0, Real d)
      : u0(-a * t0),
        u1(a * (d - t0)),
        lo(std::min(std::abs(u0), std::abs(u1))),
        hi(std::max(std::abs(u0), std::abs(u1))),
        k(a * d),
        is_short(k * (1 + lo + hi) < 1),
        straddles(u0 <= 0 && 0 <= u1) {}
};

}  // namespace

template <class Real>
LineProfile<Real> line_profile(const GaussianTerm<Real>& g, const Vec3<Real>& origin,
                               const Vec3<Real>& w) {
  const Vec3<Real> q = g.b - origin;
  if (!g.ellipsoid) {
    const Real t0 = glm::dot(q, w) / glm::dot(w, w);
    const Vec3<Real> p = g.a * (q - t0 * w);
    return {t0, glm::dot(p, p), g.a};
  }
  const auto& warp = g.ellipsoid->warp;
  const Vec3<Real> v = warp * w;
  const Real speed2 = glm::dot(v, v);
  const Real t0 = glm::dot(warp * q, v) / speed2;
  const Vec3<Real> p = g.a * (warp * (q - t0 * w));
  return {t0, glm::dot(p, p), g.a * std::sqrt(speed2)};
}

template <class Real>
Real optical_depth(const GaussianTerm<Real>& g, const LineProfile<Real>& line, Real d) {
  const NormalisedSegment<Real> s(line.a, line.t0, d);
  if (s.is_short) {
    // All terms are positive, so nothing cancels; d -> 0 gives density times length.
    const Real m = Real(0.5) * (s.u0 + s.u1);
    using Rule = ShortRule<Real>;
    Real sum = 0;
    for (std::size_t j = 0; j < Rule::node.size(); ++j) {
      const Real step = Real(0.5) * s.k * Rule::node[j];
      sum += Rule::weight[j] * std::exp(-step * step) * std::cosh(2 * m * step);
    }
    return g.c * d * std::exp(-(line.e + m * m)) * sum;
  }
  const Real scale = g.c / line.a * Real(0.5) * sqrt_pi<Real>;
  if (s.straddles) return scale * std::exp(-line.e) * (std::erf(s.u1) - std::erf(s.u0));
  // Both ends on one side: the difference of erf would cancel in the tail, that of erfc does not.
  return scale * std::exp(-line.e) * (std::erfc(s.lo) - std::erfc(s.hi));
}

template <class Real>
Real optical_depth(const GaussianTerm<Real>& g, const Vec3<Real>& A, const Vec3<Real>& B) {
  const Vec3<Real> v = B - A;
  const Real d = glm::length(v);
  if (!(d > 0)) return 0;
  return optical_depth(g, line_profile(g, A, v / d), d);
}

double optical_depth(const Gaussian& g, const glm::dvec3& A, const glm::dvec3& B) {
  return optical_depth(*StandaloneTerm(g), A, B);
}

template <class Real>
Real truncated_mean(const LineProfile<Real>& line, Real d) {
  const NormalisedSegment<Real> s(line.a, line.t0, d);
  Real mean;
  if (s.is_short) {
    const Real m = Real(0.5) * (s.u0 + s.u1);
    using Rule = ShortRule<Real>;
    Real integral = 0;
    Real moment = 0;  // of the step from the middle
    for (std::size_t j = 0; j < Rule::node.size(); ++j) {
      const Real step = Real(0.5) * s.k * Rule::node[j];
      const Real weight = Rule::weight[j] * std::exp(-step * step);
      integral += weight * std::cosh(2 * m * step);
      moment -= weight * step * std::sinh(2 * m * step);
    }
    mean = Real(0.5) * d + moment / integral / line.a;
  } else if (s.straddles) {
    const Real integral = sqrt_pi<Real> * (std::erf(s.u1) - std::erf(s.u0));
    mean = line.t0 + (std::exp(-s.u0 * s.u0) - std::exp(-s.u1 * s.u1)) / (line.a * integral);
  } else {
    // Scaled by exp(lo^2), so that the ratio lives on where both parts underflow.
    const Real decay = std::exp((s.lo - s.hi) * (s.lo + s.hi));
    const Real rest = decay > 0 ? decay * erfcx(s.hi) : Real(0);
    const Real offset = (1 - decay) / (sqrt_pi<Real> * (erfcx(s.lo) - rest)) / line.a;
    mean = s.u0 > 0 ? line.t0 + offset : line.t0 - offset;
  }
  return std::clamp(mean, Real(0), d);
}

double cutoff_radius(double radius, double density, double eps) {
  const double peak = density * radius * sqrt_pi<double>;
  return peak > eps ? radius * std::sqrt(std::log(peak / eps)) : 0.0;
}

#define BRUME_OPTICAL_DEPTH(Real)                                                               \
  template LineProfile<Real> line_profile(const GaussianTerm<Real>&, const Vec3<Real>&,         \
                                          const Vec3<Real>&);                                   \
  template Real optical_depth(const GaussianTerm<Real>&, const LineProfile<Real>&, Real);       \
  template Real optical_depth(const GaussianTerm<Real>&, const Vec3<Real>&, const Vec3<Real>&); \
  template Real truncated_mean(const LineProfile<Real>&, Real);
BRUME_OPTICAL_DEPTH(double)
BRUME_OPTICAL_DEPTH(float)
#undef BRUME_OPTICAL_DEPTH

}  // namespace brume
