#include "tools/bench/measure/view_work.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tools/bench/measure/view_work.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/gaussian-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

// A value that the compiler must take to be unknown, or used.
HWY_INLINE float Opaque(float x) {
  volatile float hidden = x;
  return hidden;
}

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

// A Gaussian on the rays of one vector; `before` is erf at the last boundary.
struct Chain {
  V t0, a, scale, length, previous_erf, depth;

  HWY_INLINE void Step(V boundary) {
    const V current_erf = erf_fast(a * (min(boundary, length) - t0));
    depth = mul_add(scale, current_erf - previous_erf, depth);
    previous_erf = current_erf;
  }
};

std::uint64_t IncrementsInRegisters(std::uint64_t count) {
  const D d;
  const float start = Opaque(0.5f);
  const auto chain = [&](float t0) HWY_ATTR {
    return Chain{hn::Set(d, t0),    hn::Set(d, start),      hn::Set(d, start),
                 hn::Set(d, 1e30f), hn::Set(d, start + t0), hn::Zero(d)};
  };
  // Enough that none waits for another; their state and the constants fill the registers.
  Chain p = chain(1.0f);
  Chain q = chain(1.1f);
  Chain r = chain(1.2f);
  V boundary = hn::Zero(d);
  const V width = hn::Set(d, 0.01f * start);
  const std::uint64_t per_step = 3 * hn::Lanes(d);
  const std::uint64_t steps = count / per_step + 1;
  for (std::uint64_t k = 0; k < steps; ++k) {
    p.Step(boundary);
    q.Step(boundary);
    r.Step(boundary);
    boundary += width;
  }
  Opaque(hn::GetLane(hn::SumOfLanes(d, p.depth + (q.depth + r.depth))));
  return steps * per_step;
}

std::uint64_t PairsInRegisters(std::uint64_t count) {
  const D d;
  const float start = Opaque(0.5f);
  const V a = hn::Set(d, start);
  const V boundary = hn::Set(d, 2.0f * start);
  const V3<V> w{hn::Set(d, 0.6f * start), hn::Set(d, 0.8f * start), hn::Set(d, start)};
  V x = hn::Zero(d);
  V sum = hn::Zero(d);
  const std::uint64_t steps = count / hn::Lanes(d) + 1;
  for (std::uint64_t k = 0; k < steps; ++k) {
    // One does not need the other: the processor overlaps them.
    const LineProfile<V> line = line_profile(V3<V>{x, a, boundary}, w, a);
    const V scale = a * exp(-line.e);
    sum = mul_add(scale, erf_fast(a * (boundary - line.t0)), sum);
    x = x + 1e-6f;
  }
  Opaque(hn::GetLane(hn::SumOfLanes(d, sum)));
  return steps * hn::Lanes(d);
}

std::size_t VectorLanes() {
  return hn::Lanes(D());
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(IncrementsInRegisters);
HWY_EXPORT(PairsInRegisters);
HWY_EXPORT(VectorLanes);

std::uint64_t increments_in_registers(std::uint64_t count) {
  return HWY_DYNAMIC_DISPATCH(IncrementsInRegisters)(count);
}

std::uint64_t pairs_in_registers(std::uint64_t count) {
  return HWY_DYNAMIC_DISPATCH(PairsInRegisters)(count);
}

std::size_t vector_lanes() {
  return HWY_DYNAMIC_DISPATCH(VectorLanes)();
}

ViewWork count_view_work(const GaussianBatch& g, const PathBatch& rays,
                         std::span<const float> boundaries, std::size_t lanes) {
  ViewWork work;
  for (std::size_t first = 0; first < rays.count; first += lanes) {
    const std::size_t end = std::min(first + lanes, rays.count);
    for (std::size_t j = 0; j < g.size(); ++j) {
      const glm::vec3 b(g.x[j], g.y[j], g.z[j]);
      float t_min = std::numeric_limits<float>::infinity();
      float t_max = -t_min;
      for (std::size_t i = first; i < end; ++i) {
        const glm::vec3 w(rays.x[i], rays.y[i], rays.z[i]);
        const float t0 = glm::dot(b, w);
        const glm::vec3 p = g.a[j] * (b - t0 * w);
        const float max_e_left = g.max_e[j] - glm::dot(p, p);
        if (max_e_left < 0.0f) continue;
        const float half = std::sqrt(max_e_left) / g.a[j];
        const float last = std::min(t0 + half, rays.length[i]);
        if (last <= std::max(t0 - half, boundaries.front())) continue;
        t_min = std::min(t_min, t0 - half);
        t_max = std::max(t_max, last);
      }
      if (t_min >= t_max || t_min >= boundaries.back()) continue;
      // The boundaries at which the first and the last of the slices end.
      const auto first_end =
          std::max(std::ranges::upper_bound(boundaries, t_min), boundaries.begin() + 1);
      const auto last_end =
          std::min(std::ranges::lower_bound(boundaries, t_max), boundaries.end() - 1);
      work.pairs += lanes;
      work.increments += static_cast<std::uint64_t>(last_end - first_end + 1) * lanes;
    }
  }
  return work;
}

}  // namespace brume
#endif
