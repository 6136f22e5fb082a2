#include "render/cpu/sweep_kernels.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/sweep_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

// A slab of nodes with a border of one node, and room for whole vectors at the end of rows.
struct Slab {
  std::size_t stride;
  std::vector<float> density;
  std::vector<float> transmittance;

  Slab(std::size_t columns, std::size_t rows)
      : stride(columns + 2 + hn::Lanes(D())),
        density(stride * (rows + 2), 0.0f),
        transmittance(stride * (rows + 2), 1.0f) {}
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

// The four nodes of the slab before that a node's light passes between.
struct Taps {
  std::ptrdiff_t first;  // offset of the lower one
  float fu, fv;

  Taps(float shift_u, float shift_v, std::size_t stride) {
    const float low_u = shift_u < 0.0f ? -1.0f : 0.0f;
    const float low_v = shift_v < 0.0f ? -1.0f : 0.0f;
    fu = shift_u - low_u;
    fv = shift_v - low_v;
    first = static_cast<std::ptrdiff_t>(low_v) * static_cast<std::ptrdiff_t>(stride) +
            static_cast<std::ptrdiff_t>(low_u);
  }

  HWY_INLINE V Mix(const float* at, std::size_t stride) const {
    const D d;
    const float* p = at + first;
    const V f = hn::Set(d, fu);
    const auto row = [&](const float* q) HWY_ATTR {
      const V low = hn::LoadU(d, q);
      return hn::MulAdd(f, hn::Sub(hn::LoadU(d, q + 1), low), low);
    };
    const V low = row(p);
    return hn::MulAdd(hn::Set(d, fv), hn::Sub(row(p + stride), low), low);
  }
};

void SweepTransmittance(const GridNodes& nodes, std::span<const float> density, const glm::vec3& w,
                        std::span<float> transmittance) {
  const D d;
  const Axes axes(nodes.count, w);
  const auto columns = static_cast<std::size_t>(nodes.count[axes.u]);
  const auto rows = static_cast<std::size_t>(nodes.count[axes.v]);
  const int slabs = nodes.count[axes.s];
  const float steep = std::abs(w[axes.s]);
  Slab before(columns, rows);
  Slab now(columns, rows);
  const Taps taps(w[axes.u] / steep, w[axes.v] / steep, now.stride);
  const V half_step = hn::Set(d, 0.5f * nodes.spacing / steep);
  for (int k = 0; k < slabs; ++k) {
    const std::ptrdiff_t slab = (w[axes.s] > 0.0f ? slabs - 1 - k : k) * axes.step_s;
    for (std::size_t v = 0; v < rows; ++v) {
      const std::ptrdiff_t row = slab + static_cast<std::ptrdiff_t>(v) * axes.step_v;
      const std::size_t start = (v + 1) * now.stride + 1;
      const float* from = density.data() + row;
      for (std::size_t u = 0; u < columns; ++u) {
        now.density[start + u] = from[static_cast<std::ptrdiff_t>(u) * axes.step_u];
      }
      for (std::size_t u = 0; u < columns; u += hn::Lanes(d)) {
        const V light = taps.Mix(before.transmittance.data() + start + u, now.stride);
        const V far = taps.Mix(before.density.data() + start + u, now.stride);
        const V near = hn::LoadU(d, now.density.data() + start + u);
        const V left = hn::Exp(d, hn::Neg(hn::Mul(half_step, hn::Add(near, far))));
        hn::StoreU(hn::Mul(light, left), d, now.transmittance.data() + start + u);
      }
      // Whole vectors have been written over the border.
      std::fill_n(now.transmittance.data() + start + columns, now.stride - columns - 1, 1.0f);
      float* to = transmittance.data() + row;
      for (std::size_t u = 0; u < columns; ++u) {
        to[static_cast<std::ptrdiff_t>(u) * axes.step_u] = now.transmittance[start + u];
      }
    }
    std::swap(before, now);
  }
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
HWY_EXPORT(AddWeighted);

void sweep_transmittance(const GridNodes& nodes, std::span<const float> density, const glm::vec3& w,
                         std::span<float> transmittance) {
  HWY_DYNAMIC_DISPATCH(SweepTransmittance)(nodes, density, w, transmittance);
}

void add_weighted(std::span<const float> transmittances, std::span<const float> weights,
                  std::size_t channels, std::size_t stride, std::size_t begin, std::size_t end,
                  std::span<float> sums) {
  HWY_DYNAMIC_DISPATCH(AddWeighted)
  (transmittances, weights, channels, stride, begin, end, sums);
}

}  // namespace brume
#endif
