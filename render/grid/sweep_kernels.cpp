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

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

// The values of a slab of nodes with a border of two nodes, and padding to full vectors at the end
// of rows.
struct Slab {
  std::size_t columns, stride;
  float border;
  std::vector<float> values;

  Slab(std::size_t width, std::size_t height, float outside)
      : columns(width),
        stride(width + 4 + hn::Lanes(D())),
        border(outside),
        values(stride * (height + 4), outside) {}

  float* row(std::size_t v) { return values.data() + (v + 2) * stride + 2; }
  // After full vectors were written over the border.
  void end_row(std::size_t v) { std::fill_n(row(v) + columns, stride - columns - 2, border); }
};

// A slab and the one before it.
struct TwoSlabs {
  Slab before, now;

  TwoSlabs(std::size_t columns, std::size_t rows, float border)
      : before(columns, rows, border), now(before) {}
  void advance() { std::swap(before, now); }
};

// Where the grid's values lie along the axes of a sweep: u and v in a slab, s from slab to slab.
struct Axes {
  int u, v, s;
  std::ptrdiff_t step_u, step_v, step_s;

  Axes(const glm::ivec3& count, const glm::vec3& w) {
    const glm::vec3 size = glm::abs(w);
    s = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    u = s == 0 ? 1 : 0;
    v = s == 2 ? 1 : 2;
    const std::ptrdiff_t step[] = {1, count.x, std::ptrdiff_t{count.x} * count.y};
    step_u = step[u];
    step_v = step[v];
    step_s = step[s];
  }
};

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

// What all sweeps share: the order of the slabs, and where rows of them lie in the grid.
struct Sweep {
  Axes axes;
  std::size_t columns, rows, slabs;
  std::ptrdiff_t first, step;  // of slabs
  float length;                // of the way between slabs [u]
  float shift_u, shift_v;

  Sweep(const GridNodes& nodes, const glm::vec3& w)
      : axes(nodes.count, w),
        columns(static_cast<std::size_t>(nodes.count[axes.u])),
        rows(static_cast<std::size_t>(nodes.count[axes.v])),
        slabs(static_cast<std::size_t>(nodes.count[axes.s])) {
    const float steep = std::abs(w[axes.s]);
    const bool backwards = w[axes.s] > 0.0f;
    first = backwards ? static_cast<std::ptrdiff_t>(slabs - 1) * axes.step_s : 0;
    step = backwards ? -axes.step_s : axes.step_s;
    length = nodes.spacing / steep;
    shift_u = w[axes.u] / steep;
    shift_v = w[axes.v] / steep;
  }
  [[nodiscard]] std::ptrdiff_t row(std::size_t slab, std::size_t v) const {
    return first + static_cast<std::ptrdiff_t>(slab) * step +
           static_cast<std::ptrdiff_t>(v) * axes.step_v;
  }
  void read(const float* input, float* target) const {
    for (std::size_t u = 0; u < columns; ++u) {
      target[u] = input[static_cast<std::ptrdiff_t>(u) * axes.step_u];
    }
  }
  void write(const float* input, float* target) const {
    for (std::size_t u = 0; u < columns; ++u) {
      target[static_cast<std::ptrdiff_t>(u) * axes.step_u] = input[u];
    }
  }
};

// The nodes of the slab before that light along a sweep passes between on its way to a node, with
// the weights of a linear interpolation.
struct Upwind {
  int u = 0, v = 0;  // offsets
  float weight = 0.0f;
  int neighbour = 0;

  [[nodiscard]] bool is_hidden_from(const OccludedNode& node) const {
    return (node.blocked >> neighbour & 1u) != 0;
  }
};

std::array<Upwind, 4> UpwindNodes(const Sweep& sweep, const glm::vec3& w) {
  const int low_u = sweep.shift_u < 0.0f ? -1 : 0;
  const int low_v = sweep.shift_v < 0.0f ? -1 : 0;
  const float f_u = sweep.shift_u - static_cast<float>(low_u);
  const float f_v = sweep.shift_v - static_cast<float>(low_v);
  std::array<Upwind, 4> upwind;
  for (int i = 0; i < 4; ++i) {
    Upwind& node = upwind[static_cast<std::size_t>(i)];
    node.u = low_u + (i & 1);
    node.v = low_v + (i >> 1);
    node.weight = ((i & 1) != 0 ? f_u : 1.0f - f_u) * ((i >> 1) != 0 ? f_v : 1.0f - f_v);
    glm::ivec3 offset(0);
    offset[sweep.axes.u] = node.u;
    offset[sweep.axes.v] = node.v;
    offset[sweep.axes.s] = w[sweep.axes.s] > 0.0f ? 1 : -1;
    node.neighbour = neighbour_index(offset.x, offset.y, offset.z);
  }
  return upwind;
}

// What a node sees of the slab before. The rest of the weights is the surfaces': so on average they
// end where they do, wherever between the nodes that is. Weighing only what is seen, slanting light
// would go on along walls.
struct Seen {
  float sum = 0.0f;
  float weight = 0.0f;
  float least = std::numeric_limits<float>::infinity();  // of values that count
  float most = 0.0f;

  Seen(std::span<const Upwind> upwind, const OccludedNode& node, Slab& slab, std::size_t u,
       std::size_t v) {
    for (const Upwind& other : upwind) {
      if (other.is_hidden_from(node)) continue;
      const auto row = static_cast<std::ptrdiff_t>(v) + other.v;
      const float* values = slab.row(0) + row * static_cast<std::ptrdiff_t>(slab.stride);
      const float value = values[static_cast<std::ptrdiff_t>(u) + other.u];
      sum += other.weight * value;
      weight += other.weight;
      if (!(other.weight > min_weight)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  [[nodiscard]] float mean() const { return weight > 0.0f ? sum / weight : 0.0f; }
  // Whether a shadow's edge may be here: some of it is lit, and some hidden or below this share of
  // the most.
  [[nodiscard]] bool is_penumbra(float lit_share) const {
    constexpr float darkest = 0.01f;
    return most > darkest && (weight < 1.0f - min_weight || least < lit_share * most);
  }
  // The light of those that are lit.
  [[nodiscard]] float lit(float lit_share) const {
    return least < lit_share * most ? most : mean();
  }

 private:
  static constexpr float min_weight = 0.01f;
};

// Index of a hidden neighbour's link.
std::size_t LinkOf(const OccludedNode& node, int neighbour) {
  const std::uint32_t before = node.blocked & ((1u << neighbour) - 1u);
  return node.first + static_cast<std::size_t>(std::popcount(before));
}

// Calls fix(u, node) for the nodes of a row that surfaces hide neighbours from.
template <class Fix>
void each_occluded(const SweepOcclusion& occlusion, const Sweep& sweep, std::ptrdiff_t row,
                   Fix fix) {
  if (occlusion.empty()) return;
  for (std::size_t u = 0; u < sweep.columns; ++u) {
    const std::ptrdiff_t i = row + static_cast<std::ptrdiff_t>(u) * sweep.axes.step_u;
    const std::int32_t index = occlusion.index[static_cast<std::size_t>(i)];
    if (index >= 0) fix(u, occlusion.nodes[static_cast<std::size_t>(index)]);
  }
}

// Where light enters the grid in a row of nodes.
struct Entry {
  bool whole_row, first, last;

  Entry(const Sweep& sweep, std::size_t slab, std::size_t v)
      : whole_row(slab == 0 || (sweep.shift_v < 0.0f && v == 0) ||
                  (sweep.shift_v > 0.0f && v + 1 == sweep.rows)),
        first(sweep.shift_u < 0.0f),
        last(sweep.shift_u > 0.0f) {}
  [[nodiscard]] bool holds(std::size_t u, std::size_t columns) const {
    return whole_row || (first && u == 0) || (last && u + 1 == columns);
  }
};

// Replaces the light of nodes of a row where it enters the grid by at(u).
template <class At>
void let_in(const Entry& entry, std::size_t columns, float* row, At at) {
  for (std::size_t u = 0; entry.whole_row && u < columns; ++u) row[u] = at(u);
  if (entry.first) row[0] = at(0);
  if (entry.last) row[columns - 1] = at(columns - 1);
}

// Continues a slab beyond its ends.
void extend(const Sweep& sweep, Slab& slab) {
  const auto rows = static_cast<std::ptrdiff_t>(sweep.rows);
  const auto columns = static_cast<std::ptrdiff_t>(sweep.columns);
  const auto stride = static_cast<std::ptrdiff_t>(slab.stride);
  float* const first = slab.row(0);
  for (std::ptrdiff_t v = 0; v < rows; ++v) {
    float* row = first + v * stride;
    row[-2] = row[-1] = row[0];
    row[columns] = row[columns + 1] = row[columns - 1];
  }
  for (const std::ptrdiff_t v : {-2, -1}) {
    std::copy_n(first - 2, columns + 4, first - 2 + v * stride);
    std::copy_n(first - 2 + (rows - 1) * stride, columns + 4, first - 2 + (rows - 1 - v) * stride);
  }
}

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
        float& here = light.now.row(v)[u];
        const Seen seen(upwind, node, light.before, u, v);
        if (occlusion.ends_within && !inflow.empty() && entry.holds(u, sweep.columns)) {
          here *= seen.weight;
          return;
        }
        const float far = Seen(upwind, node, b.before, u, v).mean();
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
        const Seen far(upwind, node, b.before, u, v);
        const float passes = std::exp(-sweep.length * (0.5f * (near + far.mean()) + fog));
        float sums[channels];
        for (std::size_t c = 0; c < channels; ++c) {
          sums[c] = passes * Seen(upwind, node, light[c].before, u, v).sum +
                    (1.0f - passes) * far.weight * emission[c].now.row(v)[u];
        }
        for (const Upwind& other : upwind) {
          if (!other.is_hidden_from(node)) continue;
          const std::size_t link = LinkOf(node, other.neighbour);
          const float way = occlusion.fractions[link] * sweep.length;
          const float transmitted = std::exp(-way * (near + fog));
          for (std::size_t c = 0; c < channels; ++c) {
            const float sent = outgoing.empty() ? 0.0f : outgoing[c][link];
            sums[c] += other.weight *
                       (transmitted * sent + (1.0f - transmitted) * emission[c].now.row(v)[u]);
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
