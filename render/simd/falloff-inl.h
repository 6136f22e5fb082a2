// LightFalloff in SIMD. Included once per instruction set by the files that Highway compiles for
// each.

#if defined(BRUME_FALLOFF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_FALLOFF_INL_H
#undef BRUME_FALLOFF_INL_H
#else
#define BRUME_FALLOFF_INL_H
#endif

#include <hwy/highway.h>

#include "core/scene/light_falloff.h"
#include "render/simd/gaussian-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using FloatVec = hn::Vec<FloatTag>;

HWY_INLINE FloatVec Floats(float x) {
  return hn::Set(FloatTag(), x);
}

struct FalloffFloats {
  V3<FloatVec> axis;
  FloatVec dark_cosine, per_cosine;
  LightFalloff::Shape shape = LightFalloff::Shape::isotropic;

  FalloffFloats() = default;
  HWY_INLINE explicit FalloffFloats(const LightFalloff& falloff)
      : axis{Floats(static_cast<float>(falloff.axis().x)),
             Floats(static_cast<float>(falloff.axis().y)),
             Floats(static_cast<float>(falloff.axis().z))},
        dark_cosine(Floats(static_cast<float>(falloff.dark_cosine()))),
        per_cosine(Floats(static_cast<float>(falloff.per_cosine()))),
        shape(falloff.shape()) {}

  // At the cosine of the angle from the axis.
  [[nodiscard]] HWY_INLINE FloatVec At(FloatVec cosine) const {
    const FloatTag d;
    if (shape != LightFalloff::Shape::cone) {
      const FloatVec positive = shape == LightFalloff::Shape::two_cosines
                                    ? hn::Abs(cosine)
                                    : hn::Max(cosine, hn::Zero(d));
      return hn::Min(positive, Floats(1.0f));
    }
    FloatVec share = hn::Mul(hn::Sub(cosine, dark_cosine), per_cosine);
    share = hn::Min(hn::Max(share, hn::Zero(d)), Floats(1.0f));
    return hn::Mul(share, share);
  }
};

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
