#include "render/cpu/interpolation_kernels.h"

#include <limits>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/interpolation_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

// Without vectors of four all cells are left to the caller.
std::uint32_t InterpolateCells(const CellRow& /*cells*/, float /*fy*/, float /*tolerance*/,
                               const float* /*distances*/, float* /*airlight*/,
                               float* /*transmittance*/) {
  return 0;
}

#else

using D = hn::FixedTag<float, 4>;
using V = hn::Vec<D>;

HWY_INLINE V Mix(V a, V b, V fraction) {
  return hn::MulAdd(fraction, hn::Sub(b, a), a);
}

// Whether the four pixels of a cell are where their interpolation has them.
HWY_INLINE bool IsOnInterpolatedPlane(const CellRow& cells, std::size_t i, float fy, V fx,
                                      V tolerance, const float* distances) {
  const D d;
  const V distance = hn::LoadU(d, distances);
  if (cells.kinds[i] == CellRow::Kind::open) {
    return hn::AllTrue(d, hn::Eq(distance, hn::Set(d, std::numeric_limits<float>::infinity())));
  }
  const auto distance_at = [&](std::size_t k) HWY_ATTR {
    const float a = cells.distances_above[k];
    return hn::Set(d, a + fy * (cells.distances_below[k] - a));
  };
  const V deviation = hn::Abs(hn::Sub(distance, Mix(distance_at(i), distance_at(i + 1), fx)));
  return hn::AllTrue(d, hn::Le(deviation, tolerance));
}

std::uint32_t InterpolateCells(const CellRow& cells, float fy, float tolerance,
                               const float* distances, float* airlight, float* transmittance) {
  const D d;
  alignas(16) constexpr float fractions[] = {0.0f, 0.25f, 0.5f, 0.75f};
  const V fx = hn::Load(d, fractions);
  const V down = hn::Set(d, fy);
  const V tolerance_u = hn::Set(d, tolerance);
  std::uint32_t done = 0;
  for (std::size_t i = 0; i < cells.kinds.size(); ++i) {
    if (cells.kinds[i] == CellRow::Kind::uneven) continue;
    if (!IsOnInterpolatedPlane(cells, i, fy, fx, tolerance_u, distances + 4 * i)) continue;
    const auto sample = [&](std::size_t k) HWY_ATTR {
      return Mix(hn::LoadU(d, &cells.above[k].x), hn::LoadU(d, &cells.below[k].x), down);
    };
    const V left = sample(i);
    const V right = sample(i + 1);
    const V w = Mix(hn::Broadcast<3>(left), hn::Broadcast<3>(right), fx);
    hn::StoreInterleaved3(Mix(hn::Broadcast<0>(left), hn::Broadcast<0>(right), fx),
                          Mix(hn::Broadcast<1>(left), hn::Broadcast<1>(right), fx),
                          Mix(hn::Broadcast<2>(left), hn::Broadcast<2>(right), fx), d,
                          airlight + 12 * i);
    hn::StoreInterleaved3(w, w, w, d, transmittance + 12 * i);
    done |= 1u << i;
  }
  return done;
}

#endif

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(InterpolateCells);

std::uint32_t interpolate_cells(const CellRow& cells, float fy, float tolerance,
                                const float* distances, float* airlight, float* transmittance) {
  return HWY_DYNAMIC_DISPATCH(InterpolateCells)(cells, fy, tolerance, distances, airlight,
                                                transmittance);
}

}  // namespace brume
#endif
