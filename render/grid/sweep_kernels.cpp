#include "render/grid/sweep_kernels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>
#include <vector>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/grid/sweep_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include "render/grid/sweep-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using V = hn::Vec<D>;

// Lagrange's polynomial through four values at -1, 0, 1, 2, taken at f in [0, 1]. Between two
// values only, light would spread sideways by a quarter of the spacing per node: half of the error.
struct Cubic {
  std::ptrdiff_t first;  // of the four
  std::array<float, 4> weights;

  explicit Cubic(float shift) {
    const float low = shift < 0.0f ? -1.0f : 0.0f;
    const float f = shift - low;
    first = static_cast<std::ptrdiff_t>(low) - 1;
    weights = {-f * (f - 1.0f) * (f - 2.0f) / 6.0f, (f + 1.0f) * (f - 1.0f) * (f - 2.0f) / 2.0f,
               -(f + 1.0f) * f * (f - 2.0f) / 2.0f, (f + 1.0f) * f * (f - 1.0f) / 6.0f};
  }
};

// The nodes of the slab before that a node's light passes between.
class Taps {
 public:
  Taps(float shift_u, float shift_v, std::size_t stride)
      : u_(shift_u),
        v_(shift_v),
        first_(v_.first * static_cast<std::ptrdiff_t>(stride) + u_.first) {}

  HWY_INLINE V Mix(const float* values, std::size_t stride) const {
    const D d;
    const float* row = values + first_;
    V sum = hn::Zero(d);
    for (const float weight_v : v_.weights) {
      V mixed = hn::Zero(d);
      for (std::size_t k = 0; k < 4; ++k) {
        mixed = hn::MulAdd(hn::Set(d, u_.weights[k]), hn::LoadU(d, row + k), mixed);
      }
      sum = hn::MulAdd(hn::Set(d, weight_v), mixed, sum);
      row += stride;
    }
    return sum;
  }

 private:
  Cubic u_, v_;
  std::ptrdiff_t first_;
};

void SweepTransmittance(const GridNodes& nodes, std::span<const float> density, const glm::vec3& w,
                        const SweepOcclusion& occlusion, std::span<const float> inflow,
                        std::span<float> transmittance) {
  const D d;
  const Sweep sweep(nodes, w);
  TwoSlabs b(sweep.columns, sweep.rows, 0.0f);
  TwoSlabs light(sweep.columns, sweep.rows, 1.0f);
  const std::size_t stride = b.now.stride;
  const Taps taps(sweep.shift_u, sweep.shift_v, stride);
  const std::array<Upwind, 4> upwind = UpwindNodes(sweep, w);
  const V half_step = hn::Set(d, 0.5f * sweep.length);
  for (std::size_t k = 0; k < sweep.slabs; ++k) {
    for (std::size_t v = 0; v < sweep.rows; ++v) {
      const std::ptrdiff_t row = sweep.row(k, v);
      sweep.read(density.data() + row, b.now.row(v));
      for (std::size_t u = 0; u < sweep.columns; u += hn::Lanes(d)) {
        const V incoming = taps.Mix(light.before.row(v) + u, stride);
        const V far = taps.Mix(b.before.row(v) + u, stride);
        const V near = hn::LoadU(d, b.now.row(v) + u);
        const V transmitted = hn::Exp(d, hn::Neg(hn::Mul(half_step, hn::Add(near, far))));
        // The polynomial overshoots where a shadow begins within a node or two.
        const V light_here =
            hn::Min(hn::Max(hn::Mul(incoming, transmitted), hn::Zero(d)), hn::Set(d, 1.0f));
        hn::StoreU(light_here, d, light.now.row(v) + u);
      }
      light.now.end_row(v);
      const Entry entry(sweep, k, v);
      if (!inflow.empty()) {
        let_in(entry, sweep.columns, light.now.row(v), [&](std::size_t u) {
          return inflow[static_cast<std::size_t>(row + static_cast<std::ptrdiff_t>(u) *
                                                           sweep.axes.step_u)];
        });
      }
      each_occluded(occlusion, sweep, row, [&](std::size_t u, const OccludedNode& node) {
        if (!inflow.empty() && entry.holds(u, sweep.columns)) return;
        float& here = light.now.row(v)[u];
        const Seen seen(occlusion, upwind, node, light.before, u, v);
        const float far = Seen(occlusion, upwind, node, b.before, u, v).mean();
        const float depth = 0.5f * sweep.length * (b.now.row(v)[u] + far);
        // Where the medium is dense it makes neighbours differ, too.
        const float lit_share = depth < 0.05f ? 0.9f : 0.5f;
        float incoming = seen.sum;
        if (occlusion.is_lit && seen.is_penumbra(lit_share)) {
          const std::ptrdiff_t i = row + static_cast<std::ptrdiff_t>(u) * sweep.axes.step_u;
          incoming = occlusion.is_lit(static_cast<std::size_t>(i)) ? seen.lit(lit_share) : 0.0f;
        }
        here = incoming * std::exp(-depth);
      });
      sweep.write(light.now.row(v), transmittance.data() + row);
    }
    if (!inflow.empty()) {
      extend(sweep, b.now);
      extend(sweep, light.now);
    }
    b.advance();
    light.advance();
  }
}

template <std::size_t channels>
void SweepChannels(const GridNodes& nodes, std::span<const float> density, float fog,
                   bool continues, std::span<const std::span<const float>> source,
                   const glm::vec3& w, const SweepOcclusion& occlusion,
                   std::span<const std::span<const float>> outgoing,
                   std::span<const std::span<float>> emitted) {
  const D d;
  const Sweep sweep(nodes, w);
  const TwoSlabs empty(sweep.columns, sweep.rows, 0.0f);
  TwoSlabs b = empty;
  std::vector<TwoSlabs> emission(channels, empty);  // source function: emission over extinction
  std::vector<TwoSlabs> light(channels, empty);
  const std::size_t stride = b.now.stride;
  const Taps taps(sweep.shift_u, sweep.shift_v, stride);
  const std::array<Upwind, 4> upwind = UpwindNodes(sweep, w);
  const V one = hn::Set(d, 1.0f);
  const V half_step = hn::Set(d, 0.5f * sweep.length);
  const V fog_step = hn::Set(d, fog * sweep.length);
  for (std::size_t k = 0; k < sweep.slabs; ++k) {
    for (std::size_t v = 0; v < sweep.rows; ++v) {
      const std::ptrdiff_t row = sweep.row(k, v);
      sweep.read(density.data() + row, b.now.row(v));
      for (std::size_t c = 0; c < channels; ++c) {
        sweep.read(source[c].data() + row, emission[c].now.row(v));
      }
      for (std::size_t u = 0; u < sweep.columns; u += hn::Lanes(d)) {
        const V near = hn::LoadU(d, b.now.row(v) + u);
        const V far = taps.Mix(b.before.row(v) + u, stride);
        const V depth = hn::MulAdd(half_step, hn::Add(near, far), fog_step);
        const V transmitted = hn::Exp(d, hn::Neg(depth));
        // The source is linear in the optical depth x on the way: its ends have the weights
        // 1 - (1 - e^-x) / x and (1 - e^-x) / x - e^-x, which lose their digits for small x.
        const auto is_thin = hn::Lt(depth, hn::Set(d, 0.05f));
        const V mean = hn::Div(hn::Sub(one, transmitted), hn::Max(depth, hn::Set(d, 1e-6f)));
        const V half_depth = hn::Mul(hn::Set(d, 0.5f), depth);
        const V third = hn::Set(d, 1.0f / 3.0f);
        const V weight_near = hn::IfThenElse(
            is_thin, hn::Mul(half_depth, hn::NegMulAdd(third, depth, one)), hn::Sub(one, mean));
        const V weight_far = hn::IfThenElse(
            is_thin, hn::Mul(half_depth, hn::NegMulAdd(hn::Add(third, third), depth, one)),
            hn::Sub(mean, transmitted));
        // Of a node without extinction the limit: cells between it and others emit all along.
        const V extinction = hn::Add(near, hn::Set(d, fog));
        const V scattering =
            hn::IfThenElse(hn::Gt(extinction, hn::Zero(d)),
                           hn::Div(near, hn::Max(extinction, hn::Set(d, 1e-30f))), one);
        for (std::size_t c = 0; c < channels; ++c) {
          float* source_row = emission[c].now.row(v) + u;
          const V emitted_here = hn::Mul(scattering, hn::LoadU(d, source_row));
          hn::StoreU(emitted_here, d, source_row);
          const V from_here =
              hn::MulAdd(weight_near, emitted_here,
                         hn::Mul(weight_far, taps.Mix(emission[c].before.row(v) + u, stride)));
          const V incoming = taps.Mix(light[c].before.row(v) + u, stride);
          hn::StoreU(hn::MulAdd(incoming, transmitted, from_here), d, light[c].now.row(v) + u);
        }
      }
      for (std::size_t c = 0; c < channels; ++c) {
        emission[c].now.end_row(v);
        light[c].now.end_row(v);
      }
      each_occluded(occlusion, sweep, row, [&](std::size_t u, const OccludedNode& node) {
        const float near = b.now.row(v)[u];
        const Seen far(occlusion, upwind, node, b.before, u, v);
        const float passes = std::exp(-sweep.length * (0.5f * (near + far.mean()) + fog));
        float sums[channels];
        for (std::size_t c = 0; c < channels; ++c) {
          sums[c] = passes * Seen(occlusion, upwind, node, light[c].before, u, v).sum +
                    (1.0f - passes) * far.weight * emission[c].now.row(v)[u];
        }
        for (const Upwind& other : upwind) {
          if (!other.is_hidden_from(node)) continue;
          const std::size_t link = LinkOf(node, other.neighbour);
          const float way = occlusion.fractions[link] * sweep.length;
          const float transmitted = std::exp(-way * (near + fog));
          // The rest of the way's light is that of what is seen.
          const float sends = (1.0f - PassingOf(occlusion, link)) * (1.0f - transmitted);
          for (std::size_t c = 0; c < channels; ++c) {
            const float sent = outgoing.empty() ? 0.0f : outgoing[c][link];
            sums[c] += other.weight * (transmitted * sent + sends * emission[c].now.row(v)[u]);
          }
        }
        for (std::size_t c = 0; c < channels; ++c) light[c].now.row(v)[u] = sums[c];
      });
      for (std::size_t c = 0; c < channels; ++c) {
        if (continues) {
          let_in(Entry(sweep, k, v), sweep.columns, light[c].now.row(v),
                 [](std::size_t) { return 0.0f; });
        }
        sweep.write(light[c].now.row(v), emitted[c].data() + row);
      }
    }
    if (continues) {
      extend(sweep, b.now);
      for (std::size_t c = 0; c < channels; ++c) {
        extend(sweep, emission[c].now);
        extend(sweep, light[c].now);
      }
    }
    b.advance();
    for (std::size_t c = 0; c < channels; ++c) {
      emission[c].advance();
      light[c].advance();
    }
  }
}

void SweepEmission(const GridNodes& nodes, std::span<const float> density, float fog,
                   bool continues, std::span<const std::span<const float>> source,
                   const glm::vec3& w, const SweepOcclusion& occlusion,
                   std::span<const std::span<const float>> outgoing,
                   std::span<const std::span<float>> emitted) {
  assert(source.size() == emitted.size() && (source.size() == 1 || source.size() == 3));
  const auto sweep = source.size() == 1 ? SweepChannels<1> : SweepChannels<3>;
  sweep(nodes, density, fog, continues, source, w, occlusion, outgoing, emitted);
}

void AddWeighted(std::span<const float> transmittances, std::span<const float> weights,
                 std::size_t channels, std::size_t stride, std::size_t begin, std::size_t end,
                 std::span<float> sums) {
  const D d;
  for (std::size_t i = begin; i < end; i += hn::Lanes(d)) {
    for (std::size_t c = 0; c < channels; ++c) {
      V sum = hn::LoadU(d, sums.data() + c * stride + i);
      for (std::size_t k = 0; k * channels < weights.size(); ++k) {
        sum = hn::MulAdd(hn::Set(d, weights[k * channels + c]),
                         hn::LoadU(d, transmittances.data() + k * stride + i), sum);
      }
      hn::StoreU(sum, d, sums.data() + c * stride + i);
    }
  }
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(SweepTransmittance);
HWY_EXPORT(SweepEmission);
HWY_EXPORT(AddWeighted);

void sweep_transmittance(const GridNodes& nodes, std::span<const float> density, const glm::vec3& w,
                         const SweepOcclusion& occlusion, std::span<const float> inflow,
                         std::span<float> transmittance) {
  HWY_DYNAMIC_DISPATCH(SweepTransmittance)(nodes, density, w, occlusion, inflow, transmittance);
}

void sweep_emission(const GridNodes& nodes, std::span<const float> density, float fog,
                    bool continues, std::span<const std::span<const float>> source,
                    const glm::vec3& w, const SweepOcclusion& occlusion,
                    std::span<const std::span<const float>> outgoing,
                    std::span<const std::span<float>> emitted) {
  HWY_DYNAMIC_DISPATCH(SweepEmission)
  (nodes, density, fog, continues, source, w, occlusion, outgoing, emitted);
}

void add_weighted(std::span<const float> transmittances, std::span<const float> weights,
                  std::size_t channels, std::size_t stride, std::size_t begin, std::size_t end,
                  std::span<float> sums) {
  HWY_DYNAMIC_DISPATCH(AddWeighted)
  (transmittances, weights, channels, stride, begin, end, sums);
}

}  // namespace brume
#endif
