#include "render/reference/gaussian_sums.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/reference/gaussian_sums.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/gaussian-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

// Arrays are padded with Gaussians of no density, so whole vectors are read.
void CrossingSums(const double* a, const double* t0, const double* peak, const double* scale,
                  const double* start, std::size_t count, double t, double* sums) {
  const D d;
  V density = hn::Zero(d);
  V depth = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V ai = hn::LoadU(d, a + i);
    const V ti = hn::LoadU(d, t0 + i);
    const V u = ai * (t - ti);
    const V decay = exp(-(u * u));
    density = mul_add(hn::LoadU(d, peak + i), decay, density);
    const V begin = hn::LoadU(d, start + i);
    const V end = decay * erfcx(abs(u));
    const auto straddles = hn::And(ti >= 0.0f, u >= 0.0f);
    const V across = 2.0 - begin - end;
    const V s = select(straddles, across, abs(begin - end));
    depth = mul_add(hn::LoadU(d, scale + i), s, depth);
  }
  sums[0] = hn::GetLane(hn::SumOfLanes(d, density));
  sums[1] = hn::GetLane(hn::SumOfLanes(d, depth));
}

double DepthFromLight(const double* x, const double* y, const double* z, const double* a,
                      const double* scale, const double* cutoff2, std::size_t count,
                      const glm::dvec3& direction, double r) {
  const D d;
  const V3<V> u{hn::Set(d, direction.x), hn::Set(d, direction.y), hn::Set(d, direction.z)};
  const V length = hn::Set(d, r);
  V sum = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V3<V> q{hn::LoadU(d, x + i), hn::LoadU(d, y + i), hn::LoadU(d, z + i)};
    const V t = clamp(dot(q, u), 0.0f, length);
    const V3<V> offset = neg_mul_add(t, u, q);
    const auto near = dot(offset, offset) < hn::LoadU(d, cutoff2 + i);
    if (hn::AllFalse(d, near)) continue;
    const V ai = hn::LoadU(d, a + i);
    const V depth = hn::LoadU(d, scale + i) * unit_depth(line_profile(q, u, ai), length);
    sum += where(near, depth);
  }
  return hn::GetLane(hn::SumOfLanes(d, sum));
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {
namespace {

// Full vectors are loaded.
constexpr std::size_t padding = 8;

template <class Real>
void pad(std::vector<Real>& values, Real value) {
  while (values.size() % padding != 0) values.push_back(value);
}

}  // namespace

HWY_EXPORT(CrossingSums);
HWY_EXPORT(DepthFromLight);

template <class Real>
void Crossings<Real>::add(const GaussianTerm<Real>& g, const LineProfile<Real>& line) {
  const Real decay = std::exp(-line.e);
  const Real scale = g.c / line.a * Real(0.5) * std::sqrt(std::numbers::pi_v<Real>) * decay;
  if (!(scale > 0)) return;
  all_.push_back({line.a, line.t0, g.c * decay, scale, std::erfc(std::abs(line.a * line.t0))});
}

template <class Real>
void Crossings<Real>::finish() {
  for (const Crossing& c : all_) {
    a_.push_back(c.a);
    t0_.push_back(c.t0);
    peak_.push_back(c.peak);
    scale_.push_back(c.scale);
    start_.push_back(c.start);
  }
  pad(a_, Real(1));
  for (auto* values : {&t0_, &peak_, &scale_, &start_}) pad(*values, Real(0));
}

template <class Real>
typename Crossings<Real>::Sums Crossings<Real>::at(Real t) const {
  if constexpr (sizeof(Real) == sizeof(double)) {
    double sums[2];
    HWY_DYNAMIC_DISPATCH(CrossingSums)
    (a_.data(), t0_.data(), peak_.data(), scale_.data(), start_.data(), a_.size(), t, sums);
    return {sums[0], sums[1]};
  } else {
    Sums sums{0, 0};
    for (const Crossing& c : all_) {
      const Real u = c.a * (t - c.t0);
      sums.density += c.peak * std::exp(-u * u);
      const Real end = std::erfc(std::abs(u));
      const bool straddles = c.t0 >= 0 && u >= 0;
      sums.depth += c.scale * (straddles ? 2 - c.start - end : std::abs(c.start - end));
    }
    return sums;
  }
}

template <class Real>
void GaussiansAroundLight<Real>::add(const GaussianTerm<Real>& g, Real cutoff_radius) {
  if (g.ellipsoid) {
    ellipsoids_.push_back({g, cutoff_radius * g.a});
    return;
  }
  const Vec3<Real> q = g.b - light_;
  x_.push_back(q.x);
  y_.push_back(q.y);
  z_.push_back(q.z);
  a_.push_back(g.a);
  scale_.push_back(g.c / g.a * Real(0.5) * std::sqrt(std::numbers::pi_v<Real>));
  cutoff2_.push_back(cutoff_radius * cutoff_radius);
}

template <class Real>
void GaussiansAroundLight<Real>::finish() {
  for (auto* values : {&x_, &y_, &z_, &scale_}) pad(*values, Real(0));
  pad(a_, Real(1));
  pad(cutoff2_, Real(-1));
}

template <class Real>
Real GaussiansAroundLight<Real>::depth(const Vec3<Real>& u, Real r) const {
  Real sum = 0;
  for (const auto& [g, cutoff_in_radii] : ellipsoids_) {
    const LineProfile<Real> line = line_profile(g, light_, u);
    if (line.e < cutoff_in_radii * cutoff_in_radii) sum += optical_depth(g, line, r);
  }
  if constexpr (sizeof(Real) == sizeof(double)) {
    return sum + HWY_DYNAMIC_DISPATCH(DepthFromLight)(x_.data(), y_.data(), z_.data(), a_.data(),
                                                      scale_.data(), cutoff2_.data(), x_.size(), u,
                                                      r);
  } else {
    const Real half_line = Real(0.5) * std::sqrt(std::numbers::pi_v<Real>);
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const Vec3<Real> q(x_[i], y_[i], z_[i]);
      const Vec3<Real> offset = q - std::clamp(glm::dot(q, u), Real(0), r) * u;
      if (!(glm::dot(offset, offset) < cutoff2_[i])) continue;
      const GaussianTerm<Real> g(a_[i], scale_[i] * a_[i] / half_line, q);
      sum += optical_depth(g, line_profile(g, Vec3<Real>(0), u), r);
    }
    return sum;
  }
}

template class Crossings<double>;
template class Crossings<float>;
template class GaussiansAroundLight<double>;
template class GaussiansAroundLight<float>;

}  // namespace brume
#endif
