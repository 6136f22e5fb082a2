#include "render/paths/path_kernels.h"

#include <cmath>
#include <numbers>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/paths/path_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/gaussian-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

// At most eight lanes, the padding of the arrays.
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;

double SegmentDepth(const double* x, const double* y, const double* z, const double* a,
                    const double* scale, const double* cutoff2, std::size_t count,
                    const glm::dvec3& origin, const glm::dvec3& direction, double length) {
  const D d;
  const V3<V> u{hn::Set(d, direction.x), hn::Set(d, direction.y), hn::Set(d, direction.z)};
  const V ox = hn::Set(d, origin.x);
  const V oy = hn::Set(d, origin.y);
  const V oz = hn::Set(d, origin.z);
  const V end = hn::Set(d, length);
  V sum = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V3<V> q{hn::Sub(hn::LoadU(d, x + i), ox), hn::Sub(hn::LoadU(d, y + i), oy),
                  hn::Sub(hn::LoadU(d, z + i), oz)};
    const V t = hn::Min(hn::Max(dot(q, u), hn::Zero(d)), end);
    const V3<V> offset = minus(q, t, u);
    const auto near = hn::Lt(dot(offset, offset), hn::LoadU(d, cutoff2 + i));
    if (hn::AllFalse(d, near)) continue;
    const V ai = hn::LoadU(d, a + i);
    const V depth =
        hn::Mul(hn::LoadU(d, scale + i), LineProfile<D>(q, u, ai).UnitDepth(d, ai, end));
    sum = hn::Add(sum, hn::IfThenElseZero(near, depth));
  }
  return hn::GetLane(hn::SumOfLanes(d, sum));
}

double PointDensity(const double* x, const double* y, const double* z, const double* a,
                    const double* peak, const std::uint32_t* indices, std::size_t count,
                    const glm::dvec3& point) {
  const D d;
  const hn::Rebind<std::int64_t, D> di;
  const hn::Rebind<std::int32_t, D> d32;
  V sum = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto at =
        hn::PromoteTo(di, hn::LoadU(d32, reinterpret_cast<const std::int32_t*>(indices + i)));
    const V ai = hn::GatherIndex(d, a, at);
    const V qx = hn::Mul(ai, hn::Sub(hn::GatherIndex(d, x, at), hn::Set(d, point.x)));
    const V qy = hn::Mul(ai, hn::Sub(hn::GatherIndex(d, y, at), hn::Set(d, point.y)));
    const V qz = hn::Mul(ai, hn::Sub(hn::GatherIndex(d, z, at), hn::Set(d, point.z)));
    const V e = hn::MulAdd(qx, qx, hn::MulAdd(qy, qy, hn::Mul(qz, qz)));
    const V density = hn::Mul(hn::GatherIndex(d, peak, at), hn::Exp(d, hn::Neg(e)));
    sum = hn::Add(sum, hn::IfThenElseZero(hn::FirstN(d, count - i), density));
  }
  return hn::GetLane(hn::SumOfLanes(d, sum));
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(SegmentDepth);
HWY_EXPORT(PointDensity);

void GaussianArrays::clear() {
  for (auto* values : {&x_, &y_, &z_, &a_, &peak_, &scale_, &cutoff2_}) values->clear();
  size_ = 0;
}

void GaussianArrays::add(const GaussianTerm<double>& g, double cutoff_radius) {
  x_.push_back(g.b.x);
  y_.push_back(g.b.y);
  z_.push_back(g.b.z);
  a_.push_back(g.a);
  peak_.push_back(g.c);
  scale_.push_back(g.c / g.a * 0.5 * std::sqrt(std::numbers::pi));
  cutoff2_.push_back(cutoff_radius > 0.0 ? cutoff_radius * cutoff_radius : -1.0);
  ++size_;
}

void GaussianArrays::add(const GaussianArrays& from, std::size_t i) {
  x_.push_back(from.x_[i]);
  y_.push_back(from.y_[i]);
  z_.push_back(from.z_[i]);
  a_.push_back(from.a_[i]);
  peak_.push_back(from.peak_[i]);
  scale_.push_back(from.scale_[i]);
  cutoff2_.push_back(from.cutoff2_[i]);
  ++size_;
}

void GaussianArrays::pad() {
  const std::size_t padded = (size_ + max_lanes - 1) / max_lanes * max_lanes;
  for (auto* values : {&x_, &y_, &z_, &peak_, &scale_}) values->resize(padded, 0.0);
  a_.resize(padded, 1.0);
  cutoff2_.resize(padded, -1.0);
}

double GaussianArrays::depth(const glm::dvec3& origin, const glm::dvec3& w, double length) const {
  return HWY_DYNAMIC_DISPATCH(SegmentDepth)(x_.data(), y_.data(), z_.data(), a_.data(),
                                            scale_.data(), cutoff2_.data(), size_, origin, w,
                                            length);
}

double GaussianArrays::density(std::span<const std::uint32_t> indices, const glm::dvec3& x) const {
  return HWY_DYNAMIC_DISPATCH(PointDensity)(x_.data(), y_.data(), z_.data(), a_.data(),
                                            peak_.data(), indices.data(), indices.size(), x);
}

}  // namespace brume
#endif
