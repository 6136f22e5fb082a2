// SpotFalloff in SIMD. Included once per instruction set by the files that Highway compiles for
// each.

#if defined(BRUME_SPOT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_SPOT_INL_H
#undef BRUME_SPOT_INL_H
#else
#define BRUME_SPOT_INL_H
#endif

#include <hwy/highway.h>

#include "core/transport/spot_falloff.h"
#include "render/simd/gaussian-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using FloatVec = hn::Vec<FloatTag>;

HWY_INLINE FloatVec Floats(float x) {
  return hn::Set(FloatTag(), x);
}

struct SpotFloats {
  V3<FloatVec> axis;
  FloatVec dark_cosine, per_cosine;

  SpotFloats() = default;
  HWY_INLINE explicit SpotFloats(const SpotFalloff& spot)
      : axis{Floats(static_cast<float>(spot.axis().x)), Floats(static_cast<float>(spot.axis().y)),
             Floats(static_cast<float>(spot.axis().z))},
        dark_cosine(Floats(static_cast<float>(spot.dark_cosine()))),
        per_cosine(Floats(static_cast<float>(spot.per_cosine()))) {}

  // At the cosine of the angle from the axis.
  [[nodiscard]] HWY_INLINE FloatVec At(FloatVec cosine) const {
    const FloatTag d;
    FloatVec share = hn::Mul(hn::Sub(cosine, dark_cosine), per_cosine);
    share = hn::Min(hn::Max(share, hn::Zero(d)), Floats(1.0f));
    return hn::Mul(share, share);
  }
};

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
