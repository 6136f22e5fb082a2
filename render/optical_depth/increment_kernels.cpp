#include "render/optical_depth/increment_kernels.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/optical_depth/increment_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/gaussian-inl.h"
#include "render/simd/noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using Vector = V3<V>;

HWY_INLINE V set(float x) {
  return hn::Set(D(), x);
}

// A cone around the rays of a group; of parallel ones a cylinder.
struct GroupCone {
  glm::vec3 axis{0.0f};    // unit
  float spread = 0.0f;     // maximum distance of a ray's direction from it
  glm::vec3 origin{0.0f};  // where the axis starts
  float width = 0.0f;      // maximum distance of a parallel ray from it [u]

  GroupCone(const PathBatch& rays, std::size_t first) {
    const std::size_t end = std::min(first + RaySlices::group, rays.count);
    const auto direction = [&](std::size_t i) {
      return glm::vec3(rays.x[i], rays.y[i], rays.z[i]);
    };
    for (std::size_t i = first; i < end; ++i) axis += direction(i);
    const float length = glm::length(axis);
    axis = length > 0.0f ? axis / length : direction(first);
    for (std::size_t i = first; i < end; ++i) {
      spread = std::max(spread, glm::length(direction(i) - axis));
    }
    if (rays.has_offsets()) add_offsets(rays, first, end);
  }

 private:
  void add_offsets(const PathBatch& rays, std::size_t first, std::size_t end) {
    const auto offset = [&](std::size_t i) {
      return glm::vec3(rays.offset_x[i], rays.offset_y[i], rays.offset_z[i]);
    };
    for (std::size_t i = first; i < end; ++i) origin += offset(i);
    origin /= static_cast<float>(std::max<std::size_t>(end - first, 1));
    for (std::size_t i = first; i < end; ++i) {
      width = std::max(width, glm::length(offset(i) - origin));
    }
  }
};

// Room for the rounding of floats: relative to the cutoff radius, and to the distance.
constexpr float cutoff_room = 1e-3f;
constexpr float distance_room = 1e-6f;

// Gaussians that rays of a group may meet, and the slices on which.
struct MetGaussians {
  std::vector<std::int32_t> gaussian, first, end;
  std::size_t count = 0;

  void reset(std::size_t max_count) {
    count = 0;
    // Whole vectors are stored.
    for (auto* values : {&gaussian, &first, &end}) values->resize(padded(max_count) + padded(1));
  }
  template <class I, class M>
  HWY_INLINE void add(M chosen, I gaussians, I firsts, I ends) {
    const hn::RebindToSigned<D> d;
    hn::CompressBlendedStore(gaussians, chosen, d, gaussian.data() + count);
    hn::CompressBlendedStore(firsts, chosen, d, first.data() + count);
    count += hn::CompressBlendedStore(ends, chosen, d, end.data() + count);
  }
};

// Those of a group by what they cost: boundaries that all rays of the group pass before a Gaussian
// or behind it need no erf.
struct GroupGaussians {
  MetGaussians whole;  // on one slice
  MetGaussians cut;    // by one boundary
  MetGaussians other;

  void choose(const GaussianBatch& g, const PathBatch& rays, const RaySlices& slices,
              std::size_t group);
  // Half the depth of a line through the center of Gaussian j, at most, along rays of the group.
  template <BatchKind kKind>
  [[nodiscard]] float half_depth(const GaussianBatch& g, std::size_t j) const {
    return kKind == BatchKind::ellipsoids ? half_depths[j] : g.scale[j];
  }

 private:
  // Drops ellipsoids that no ray meets from those in `near_rays`; returns how many are
  // left.
  std::size_t drop_ellipsoids(const GaussianBatch& g, const GroupCone& cone, std::size_t count);

  std::vector<std::int32_t> near_rays;
  std::vector<float> half_depths;  // of those, if there are ellipsoids
};

std::size_t GroupGaussians::drop_ellipsoids(const GaussianBatch& g, const GroupCone& cone,
                                            std::size_t count) {
  const D d;
  const hn::RebindToSigned<D> di;
  const Vector axis{set(cone.axis.x), set(cone.axis.y), set(cone.axis.z)};
  const Vector origin{set(cone.origin.x), set(cone.origin.y), set(cone.origin.z)};
  constexpr auto floats = static_cast<std::int32_t>(sizeof(BatchEllipsoid) / sizeof(float));
  static_assert(floats * sizeof(float) == sizeof(BatchEllipsoid));
  const float* const members = g.ellipsoids[0].warp.data();
  const auto end = near_rays.begin() + static_cast<std::ptrdiff_t>(count);
  std::fill_n(end, hn::Lanes(d), 0);  // whole vectors are loaded
  half_depths.resize(padded(g.size()));
  std::size_t left = 0;
  for (std::size_t m = 0; m < count; m += hn::Lanes(d)) {
    const auto j = hn::LoadU(di, near_rays.data() + m);
    const auto first = j * floats;
    const auto member = [&](std::int32_t k)
                            HWY_ATTR { return hn::GatherIndex(d, members, first + k); };
    const WarpOf<V> warp{member(0), member(1), member(2), member(3), member(4), member(5)};
    const V a = hn::GatherIndex(d, g.a.data(), j);
    const Vector center =
        neg_mul_add(set(1.0f), warp(origin), Vector{member(6), member(7), member(8)});
    const LineProfile<V> line = warped_line_profile(center, warp(axis), a);
    // A ray that is off the axis by the spread, or rounded, is nearer by at most this, where it
    // still matters.
    const V far = hn::GatherIndex(d, g.far.data(), j);
    const V of_spread = a * far * ((cone.spread + distance_room) * member(9));
    const V nearer = mul_add(a * cone.width, member(9), of_spread);
    const auto is_ball = hn::Eq(warp.xx, hn::Zero(d));
    // Along such a ray it is no longer than this.
    const V slowest = neg_mul_add(a * cone.spread, member(9), line.a);
    const V scale = hn::GatherIndex(d, g.scale.data(), j);
    const V half_depth = select(hn::Or(is_ball, slowest <= a), scale, scale * a / slowest);
    hn::ScatterIndex(half_depth, d, half_depths.data(), j);
    const V reach = a * hn::GatherIndex(d, g.reach.data(), j);  // in radii
    const auto meets = sqrt(line.e) <= mul_add(reach, 1.0f + cutoff_room, nearer);
    const auto kept = hn::And(hn::FirstN(d, count - m), hn::Or(is_ball, meets));
    left += hn::CompressBlendedStore(j, hn::RebindMask(di, kept), di, near_rays.data() + left);
  }
  return left;
}

void GroupGaussians::choose(const GaussianBatch& g, const PathBatch& rays, const RaySlices& slices,
                            std::size_t group) {
  const D d;
  const hn::RebindToSigned<D> di;
  using I = hn::Vec<decltype(di)>;
  const GroupCone cone(rays, group);
  const Vector axis{set(cone.axis.x), set(cone.axis.y), set(cone.axis.z)};
  const bool is_parallel = rays.has_offsets();
  const Vector origin{set(cone.origin.x), set(cone.origin.y), set(cone.origin.z)};
  const V width = set(cone.width * (1.0f + cutoff_room) +
                      distance_room * (glm::length(cone.origin) + cone.width));
  // The nearest ray passes a center at h * nearing - t * spread or farther.
  const V nearing = set(std::sqrt(std::max(1.0f - cone.spread * cone.spread, 0.0f)));
  const V spread = set(cone.spread * (1.0f + cutoff_room));
  const std::span<const float> nearest = slices.nearest(group);
  const std::span<const float> farthest = slices.farthest(group);
  const auto last = static_cast<std::int32_t>(slices.count() - 1);
  const float* const lengths = rays.length.data() + group;
  const V shortest = set(*std::min_element(lengths, lengths + RaySlices::group));
  const I one = hn::Set(di, 1);
  for (auto* list : {&whole, &cut, &other}) list->reset(g.size());
  near_rays.resize(padded(g.size()) + padded(1));
  std::size_t near_count = 0;
  for (std::size_t j = 0; j < g.size(); j += hn::Lanes(d)) {
    const auto load = [&](const std::vector<float>& values)
                          HWY_ATTR { return hn::LoadU(d, values.data() + j); };
    Vector b{load(g.x), load(g.y), load(g.z)};
    if (is_parallel) b = neg_mul_add(set(1.0f), origin, b);
    const V t = dot(b, axis);
    const Vector p = neg_mul_add(t, axis, b);
    const V h = sqrt(dot(p, p));
    V reach = mul_add(distance_room, abs(t) + h, load(g.reach) * (1.0f + cutoff_room));
    if (is_parallel) reach = reach + width;
    const auto met =
        hn::And(hn::FirstN(d, g.size() - j), nearing * h <= mul_add(max(t, 0.0f), spread, reach));
    near_count +=
        hn::CompressBlendedStore(hn::Iota(di, static_cast<std::int32_t>(j)),
                                 hn::RebindMask(di, met), di, near_rays.data() + near_count);
  }
  if (!g.ellipsoids.empty()) near_count = drop_ellipsoids(g, cone, near_count);
  // Where nothing was stored, any Gaussian.
  std::fill_n(near_rays.begin() + static_cast<std::ptrdiff_t>(near_count), hn::Lanes(d), 0);
  for (std::size_t m = 0; m < near_count; m += hn::Lanes(d)) {
    const I j = hn::LoadU(di, near_rays.data() + m);
    const V near = hn::GatherIndex(d, g.near.data(), j);
    const V far = hn::GatherIndex(d, g.far.data(), j);
    // Boundaries are in order: those before a Gaussian and before its end are counted.
    I before = hn::Zero(di);
    I until = hn::Zero(di);
    const auto counted = [&](I count, auto is) HWY_ATTR {
      return count - hn::VecFromMask(di, hn::RebindMask(di, is));
    };
    for (std::size_t k = 0; k < slices.count(); ++k) {
      before = counted(before, farthest[k] <= near);
      until = counted(until, nearest[k] < far);
    }
    const I first = max(before, one) - one;
    const I end = min(until, last);
    const I slice_count = end - first;
    const auto on_slices = hn::And(hn::FirstN(di, near_count - m), slice_count > 0);
    // Neither its beginning nor its end is cut off.
    const auto& thicknesses = g.ellipsoids.empty() ? g.scale : half_depths;
    const V half_depth = hn::GatherIndex(d, thicknesses.data(), j);
    const auto is_inside = hn::And(
        hn::And(on_slices, before > 0),
        hn::RebindMask(
            di, hn::And(hn::And(hn::GatherIndex(d, nearest.data(), end) >= far, shortest >= far),
                        half_depth <= exact_above)));
    const auto is_whole = hn::And(is_inside, hn::Eq(slice_count, one));
    const auto is_cut = hn::And(is_inside, hn::Eq(slice_count, one + one));
    whole.add(is_whole, j, first, end);
    cut.add(is_cut, j, first, end);
    other.add(hn::AndNot(hn::Or(is_whole, is_cut), on_slices), j, first, end);
  }
}

template <BatchKind kKind, class Rays, bool kOptics, bool kMoments>
HWY_INLINE std::uint64_t Increments(const GaussianBatch& g, const PathBatch& paths,
                                    const RaySlices& slices, float* increments, float* moments,
                                    GroupGaussians& met) {
  const D d;
  const std::size_t stride = paths.padded_size();
  const std::size_t last = slices.count() - 1;
  const V one = set(1.0f);
  std::uint64_t pairs = 0;
  for (std::size_t i = 0; i < stride; i += hn::Lanes(d)) {
    if (i % RaySlices::group == 0) met.choose(g, paths, slices, i);
    const Rays rays(d, paths, i);
    const std::span<const float> nearest = slices.nearest(i);
    const std::span<const float> farthest = slices.farthest(i);
    // Before it no ray ends.
    const float shortest = hn::GetLane(hn::MinOfLanes(d, hn::LoadU(d, paths.length.data() + i)));
    const auto add_to = [&](float* sums, std::size_t slice, V value) HWY_ATTR {
      float* const sum = sums + slice * stride + i;
      hn::StoreU(value + hn::LoadU(d, sum), d, sum);
    };
    // The depth of Gaussian j on a slice, and its moment.
    const auto add = [&](std::size_t j, std::size_t slice, V depth, V moment) HWY_ATTR {
      add_to(increments, slice, depth);
      if constexpr (kMoments) add_to(moments, slice, moment);
      if constexpr (kOptics) {
        for (std::size_t c = 0; c < g.optics.size(); ++c) {
          const V weight = set(g.optics[c][j]);
          add_to(increments + (c + 1) * last * stride, slice, weight * depth);
        }
      }
    };
    // Calls body(Gaussian, first slice, end of slices, line, half the depth of a line through its
    // center) for those that a ray meets: nothing beyond the cutoff, so that frames are the same
    // whatever rays share a vector.
    const auto each = [&](const MetGaussians& list, auto body) HWY_ATTR {
      for (std::size_t m = 0; m < list.count; ++m) {
        const auto j = static_cast<std::size_t>(list.gaussian[m]);
        const LineProfile<V> line = BatchLineProfile<kKind>(d, g, j, rays);
        const auto reached = line.e <= g.max_e[j];
        if (hn::AllFalse(d, reached)) continue;
        pairs += hn::CountTrue(d, reached);
        body(j, static_cast<std::size_t>(list.first[m]), static_cast<std::size_t>(list.end[m]),
             line, where(reached, BatchHalfDepth<kKind>(d, g, j, line)));
      }
    };
    const auto u = [&](const LineProfile<V>& line, std::size_t boundary) HWY_ATTR {
      return line.a * (hn::LoadU(d, slices.at(i, boundary)) - line.t0);
    };
    const auto middle = [&](std::size_t slice) HWY_ATTR {
      const V ends = hn::LoadU(d, slices.at(i, slice)) + hn::LoadU(d, slices.at(i, slice + 1));
      return 0.5f * ends;
    };
    // The part of a Gaussian's moment that depends on where it is cut: with exp(-u^2) there, in its
    // half depth.
    const auto cut_moment = [&](std::size_t j, const LineProfile<V>& line, V exponential) HWY_ATTR {
      if constexpr (kKind == BatchKind::ellipsoids) {
        return inv_sqrt_pi * exponential / line.a;
      }
      return static_cast<float>(inv_sqrt_pi) / g.a[j] * exponential;
    };
    each(met.whole, [&](std::size_t j, std::size_t first, std::size_t, const LineProfile<V>& line,
                        V half_depth) HWY_ATTR {
      const V scale = half_depth * exp(-line.e);
      const V depth = scale + scale;
      add(j, first, depth, depth * line.t0);
    });
    each(met.cut, [&](std::size_t j, std::size_t first, std::size_t, const LineProfile<V>& line,
                      V half_depth) HWY_ATTR {
      const V scale = half_depth * exp(-line.e);
      const V erf = erf_fast(u(line, first + 1));
      V beyond = hn::Zero(d);
      if constexpr (kMoments) beyond = scale * cut_moment(j, line, exp_of_erf(erf));
      const V before = mul_add(scale, erf, scale);
      const V behind = neg_mul_add(scale, erf, scale);
      add(j, first, before, mul_sub(before, line.t0, beyond));
      add(j, first + 1, behind, mul_add(behind, line.t0, beyond));
    });
    each(met.other, [&](std::size_t j, std::size_t first, std::size_t end,
                        const LineProfile<V>& line, V half_depth) HWY_ATTR {
      if (met.half_depth<kKind>(g, j) > exact_above) {
        V previous = u(line, first);
        for (std::size_t k = first; k < end; ++k) {
          const V current = u(line, k + 1);
          const V width = current - previous;
          const V depth = half_depth * segment_integral(line.e, previous, current, width);
          add(j, k, depth, depth * middle(k));
          previous = current;
        }
        return;
      }
      const V scale = half_depth * exp(-line.e);
      // A boundary, as the Gaussian is met there.
      struct Cut {
        V u, erf, moment;
      };
      const Cut before{set(-erf_fast_end), -one, hn::Zero(d)};
      const Cut behind{set(erf_fast_end), one, hn::Zero(d)};
      const auto cut_at = [&](std::size_t k) HWY_ATTR {
        const V at = u(line, k);
        V moment = hn::Zero(d);
        if constexpr (kMoments) moment = cut_moment(j, line, exp(-(at * at)));
        return Cut{at, erf_fast(at), moment};
      };
      Cut previous = farthest[first] <= g.near[j] ? before : cut_at(first);
      for (std::size_t k = first; k < end; ++k) {
        const bool is_behind = nearest[k + 1] >= g.far[j] && shortest >= g.far[j];
        const Cut current = is_behind ? behind : cut_at(k + 1);
        const V depth = scale * (current.erf - previous.erf);
        V moment = hn::Zero(d);
        if constexpr (kMoments) {
          const V of_both = previous.moment - current.moment;
          const auto is_short = current.u - previous.u < short_slice;
          moment = select(is_short, depth * middle(k), mul_add(depth, line.t0, scale * of_both));
        }
        add(j, k, depth, moment);
        previous = current;
      }
    });
  }
  return pairs;
}

template <BatchKind kKind, class Rays, bool kOptics>
std::uint64_t IncrementsOf(const GaussianBatch& g, const PathBatch& rays, const RaySlices& slices,
                           float* increments, float* moments, GroupGaussians& met) {
  return moments
             ? Increments<kKind, Rays, kOptics, true>(g, rays, slices, increments, moments, met)
             : Increments<kKind, Rays, kOptics, false>(g, rays, slices, increments, moments, met);
}

std::uint64_t AccumulateIncrements(const GaussianBatch& g, const PathBatch& rays,
                                   const RaySlices& slices, float* increments, float* moments) {
  thread_local GroupGaussians met;
  return WithRays(D(), rays, [&]<class Rays>() HWY_ATTR {
    return with_kind(g, [&]<BatchKind kKind>() HWY_ATTR {
      return g.has_optics()
                 ? IncrementsOf<kKind, Rays, true>(g, rays, slices, increments, moments, met)
                 : IncrementsOf<kKind, Rays, false>(g, rays, slices, increments, moments, met);
    });
  });
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(AccumulateIncrements);

std::uint64_t accumulate_increments(const GaussianBatch& gaussians, const PathBatch& rays,
                                    const RaySlices& slices, float* increments, float* moments) {
  return HWY_DYNAMIC_DISPATCH(AccumulateIncrements)(gaussians, rays, slices, increments, moments);
}

}  // namespace brume
#endif
