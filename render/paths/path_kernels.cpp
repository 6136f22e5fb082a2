#include "render/paths/path_kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
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

// A segment for vectors.
struct Segment {
  V3<V> origin, direction;
  V length;

  Segment(D d, const glm::dvec3& start, const glm::dvec3& w, double end)
      : origin{hn::Set(d, start.x), hn::Set(d, start.y), hn::Set(d, start.z)},
        direction{hn::Set(d, w.x), hn::Set(d, w.y), hn::Set(d, w.z)},
        length(hn::Set(d, end)) {}

  // Points relative to the origin.
  HWY_INLINE V3<V> Relative(D d, const double* x, const double* y, const double* z) const {
    return {hn::LoadU(d, x) - origin.x, hn::LoadU(d, y) - origin.y, hn::LoadU(d, z) - origin.z};
  }
  // Whether the segment comes nearer to them than the root of radius2.
  HWY_INLINE auto Touches(D d, const V3<V>& q, const double* radius2) const {
    const V t = clamp(dot(q, direction), 0.0f, length);
    const V3<V> offset = neg_mul_add(t, direction, q);
    return dot(offset, offset) < hn::LoadU(d, radius2);
  }
};

double SegmentDepth(const GaussianColumns& g, std::size_t cluster_count, const glm::dvec3& origin,
                    const glm::dvec3& direction, double end) {
  const D d;
  const Segment segment(d, origin, direction, end);
  V sum = hn::Zero(d);
  // The Gaussians of a group.
  const auto add = [&](std::size_t group) HWY_ATTR {
    const std::size_t first = group * GaussianArrays::max_lanes;
    for (std::size_t i = first; i < first + GaussianArrays::max_lanes; i += hn::Lanes(d)) {
      const V3<V> q = segment.Relative(d, g.x + i, g.y + i, g.z + i);
      const auto near = segment.Touches(d, q, g.cutoff2 + i);
      if (hn::AllFalse(d, near)) continue;
      const V a = hn::LoadU(d, g.a + i);
      V scale = hn::LoadU(d, g.scale + i);
      V depth;
      if (g.has_ellipsoids[group] != 0) {
        const auto load = [&](std::size_t k) HWY_ATTR { return hn::LoadU(d, g.warp[k] + i); };
        const WarpOf<V> warp{load(0), load(1), load(2), load(3), load(4), load(5)};
        const LineProfile<V> line = warped_line_profile(warp(q), warp(segment.direction), a);
        scale *= a / line.a;
        depth = scale * unit_depth(line, segment.length);
      } else {
        depth = scale * unit_depth(line_profile(q, segment.direction, a), segment.length);
      }
      sum += where(near, depth);
    }
  };
  // The balls of a row of eight that the segment touches, as bits.
  const auto touched = [&](const BallColumns& balls, std::size_t first) HWY_ATTR {
    unsigned result = 0;
    for (std::size_t i = 0; i < GaussianArrays::max_lanes; i += hn::Lanes(d)) {
      const std::size_t index = first + i;
      const V3<V> q = segment.Relative(d, balls.x + index, balls.y + index, balls.z + index);
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, segment.Touches(d, q, balls.radius2 + index), bits);
      result |= static_cast<unsigned>(bits[0]) << i;
    }
    return result;
  };
  const auto each = [](unsigned bits, std::size_t first, auto visit) HWY_ATTR {
    for (; bits != 0; bits &= bits - 1) {
      visit(first + static_cast<std::size_t>(std::countr_zero(bits)));
    }
  };
  for (std::size_t row = 0; row < cluster_count; row += GaussianArrays::max_lanes) {
    each(touched(g.clusters, row), row, [&](std::size_t cluster) HWY_ATTR {
      const std::size_t first = cluster * GaussianArrays::max_lanes;
      each(touched(g.groups, first), first, add);
    });
  }
  return hn::GetLane(hn::SumOfLanes(d, sum));
}

double PointDensity(const GaussianColumns& g, const std::uint32_t* indices, std::size_t count,
                    const glm::dvec3& point) {
  const D d;
  const hn::Rebind<std::int64_t, D> di;
  const hn::Rebind<std::int32_t, D> d32;
  V sum = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto index =
        hn::PromoteTo(di, hn::LoadU(d32, reinterpret_cast<const std::int32_t*>(indices + i)));
    const V ai = hn::GatherIndex(d, g.a, index);
    V3<V> q{ai * (hn::GatherIndex(d, g.x, index) - point.x),
            ai * (hn::GatherIndex(d, g.y, index) - point.y),
            ai * (hn::GatherIndex(d, g.z, index) - point.z)};
    if (g.warp[0]) {
      const auto gather = [&](std::size_t k)
                              HWY_ATTR { return hn::GatherIndex(d, g.warp[k], index); };
      q = WarpOf<V>{gather(0), gather(1), gather(2), gather(3), gather(4), gather(5)}(q);
    }
    const V e = dot(q, q);
    const V density = hn::GatherIndex(d, g.peak, index) * exp(-e);
    sum += where(hn::FirstN(d, count - i), density);
  }
  return hn::GetLane(hn::SumOfLanes(d, sum));
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(SegmentDepth);
HWY_EXPORT(PointDensity);

void GaussianArrays::add(const GaussianTerm<double>& g, double cutoff_radius) {
  x_.push_back(g.b.x);
  y_.push_back(g.b.y);
  z_.push_back(g.b.z);
  a_.push_back(g.a);
  peak_.push_back(g.c);
  scale_.push_back(g.c / g.a * 0.5 * std::sqrt(std::numbers::pi));
  cutoff2_.push_back(cutoff_radius > 0.0 ? cutoff_radius * cutoff_radius : -1.0);
  has_ellipsoids_.resize((x_.size() + max_lanes - 1) / max_lanes);
  if (!g.ellipsoid && warp_[0].empty()) return;
  // Those before it are balls.
  const glm::dmat3 warp = g.ellipsoid ? g.ellipsoid->warp : glm::dmat3(1.0);
  const std::array values{warp[0][0], warp[1][1], warp[2][2], warp[1][2], warp[0][2], warp[0][1]};
  for (std::size_t k = 0; k < warp_.size(); ++k) {
    warp_[k].resize(x_.size() - 1, k < 3 ? 1.0 : 0.0);
    warp_[k].push_back(values[k]);
  }
  if (g.ellipsoid) has_ellipsoids_.back() = 1;
}

void GaussianArrays::finish() {
  for (auto* values : {&x_, &y_, &z_, &peak_, &scale_}) pad(*values, 0.0);
  pad(a_, 1.0);
  pad(cutoff2_, -1.0);
  for (std::size_t k = 0; !warp_[0].empty() && k < warp_.size(); ++k) {
    pad(warp_[k], k < 3 ? 1.0 : 0.0);
  }
  groups_.enclose({x_.data(), y_.data(), z_.data(), cutoff2_.data()}, x_.size());
  clusters_.enclose(groups_.columns(), groups_.x.size());
}

void GaussianArrays::pad(std::vector<double>& values, double value) {
  values.resize((values.size() + max_lanes - 1) / max_lanes * max_lanes, value);
}

void GaussianArrays::Balls::enclose(const BallColumns& inner, std::size_t count) {
  for (std::size_t first = 0; first < count; first += max_lanes) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-std::numeric_limits<double>::infinity());
    const auto each = [&](auto visit) {
      for (std::size_t i = first; i < first + max_lanes; ++i) {
        if (!(inner.radius2[i] > 0.0)) continue;
        visit(glm::dvec3(inner.x[i], inner.y[i], inner.z[i]), std::sqrt(inner.radius2[i]));
      }
    };
    each([&](const glm::dvec3& center, double radius) {
      low = glm::min(low, center - radius);
      high = glm::max(high, center + radius);
    });
    const bool is_empty = !(low.x < high.x);
    const glm::dvec3 middle = is_empty ? glm::dvec3(0.0) : 0.5 * (low + high);
    double reach = 0.0;
    each([&](const glm::dvec3& center, double radius) {
      reach = std::max(reach, glm::length(center - middle) + radius);
    });
    x.push_back(middle.x);
    y.push_back(middle.y);
    z.push_back(middle.z);
    // A little more for its rounding.
    radius2.push_back(is_empty ? -1.0 : reach * reach * (1.0 + 1e-12));
  }
  for (auto* values : {&x, &y, &z}) pad(*values, 0.0);
  pad(radius2, -1.0);
}

GaussianColumns GaussianArrays::columns() const {
  GaussianColumns columns{.x = x_.data(),
                          .y = y_.data(),
                          .z = z_.data(),
                          .a = a_.data(),
                          .peak = peak_.data(),
                          .scale = scale_.data(),
                          .cutoff2 = cutoff2_.data(),
                          .warp = {},
                          .has_ellipsoids = has_ellipsoids_.data(),
                          .groups = groups_.columns(),
                          .clusters = clusters_.columns()};
  for (std::size_t k = 0; !warp_[0].empty() && k < warp_.size(); ++k) {
    columns.warp[k] = warp_[k].data();
  }
  return columns;
}

double GaussianArrays::depth(const glm::dvec3& origin, const glm::dvec3& w, double length) const {
  return HWY_DYNAMIC_DISPATCH(SegmentDepth)(columns(), clusters_.x.size(), origin, w, length);
}

double GaussianArrays::density(std::span<const std::uint32_t> indices, const glm::dvec3& x) const {
  return HWY_DYNAMIC_DISPATCH(PointDensity)(columns(), indices.data(), indices.size(), x);
}

}  // namespace brume
#endif
