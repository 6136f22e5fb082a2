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
#include "core/scene/photometric_profile.h"
#include "render/simd/gaussian-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using FloatVec = hn::Vec<FloatTag>;

HWY_INLINE FloatVec Floats(float x) {
  return hn::Set(FloatTag(), x);
}

HWY_INLINE V3<FloatVec> Floats(const glm::dvec3& v) {
  return {Floats(static_cast<float>(v.x)), Floats(static_cast<float>(v.y)),
          Floats(static_cast<float>(v.z))};
}

// PhotometricProfile::at() in the direction (x, y, z), of any length but 0, by its map.
HWY_INLINE FloatVec ProfileAt(const float* map, FloatVec x, FloatVec y, FloatVec z) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  constexpr int side = PhotometricProfile::side;
  constexpr float half = 0.5f * (side - 1);
  const FloatVec one = Floats(1.0f);
  const FloatVec sum = hn::Add(hn::Add(hn::Abs(x), hn::Abs(y)), hn::Abs(z));
  const FloatVec inverse = hn::Div(one, hn::Max(sum, Floats(coefficient::tiny)));
  const FloatVec u = hn::Mul(x, inverse);
  const FloatVec v = hn::Mul(y, inverse);
  const auto is_behind = hn::Lt(z, hn::Zero(d));
  const FloatVec folded_u = hn::CopySign(hn::Sub(one, hn::Abs(v)), u);
  const FloatVec folded_v = hn::CopySign(hn::Sub(one, hn::Abs(u)), v);
  const auto place = [&](FloatVec t) HWY_ATTR {
    const FloatVec in_cells = hn::MulAdd(t, Floats(half), Floats(half));
    return hn::Min(hn::Max(in_cells, hn::Zero(d)), Floats(2.0f * half));
  };
  const FloatVec column = place(hn::IfThenElse(is_behind, folded_u, u));
  const FloatVec row = place(hn::IfThenElse(is_behind, folded_v, v));
  const auto last = hn::Set(di, side - 2);
  const auto low_column = hn::Min(hn::ConvertTo(di, column), last);
  const auto low_row = hn::Min(hn::ConvertTo(di, row), last);
  const FloatVec f = hn::Sub(column, hn::ConvertTo(d, low_column));
  const FloatVec g = hn::Sub(row, hn::ConvertTo(d, low_row));
  const auto first = hn::Add(hn::Mul(low_row, hn::Set(di, side)), low_column);
  const auto mix = [&](const float* at) HWY_ATTR {
    const FloatVec low = hn::GatherIndex(d, at, first);
    const FloatVec high = hn::GatherIndex(d, at + 1, first);
    return hn::MulAdd(f, hn::Sub(high, low), low);
  };
  const FloatVec low = mix(map);
  return hn::MulAdd(g, hn::Sub(mix(map + side), low), low);
}

struct FalloffFloats {
  V3<FloatVec> axis;
  V3<FloatVec> azimuth_0, azimuth_90;  // of a profile
  const float* profile = nullptr;      // its map
  FloatVec dark_cosine, per_cosine;
  LightFalloff::Shape shape = LightFalloff::Shape::isotropic;
  bool has_cone = false;

  FalloffFloats() = default;
  HWY_INLINE explicit FalloffFloats(const LightFalloff& falloff)
      : axis(Floats(falloff.axis())),
        azimuth_0(Floats(falloff.azimuth_0())),
        azimuth_90(Floats(falloff.azimuth_90())),
        profile(falloff.profile() ? falloff.profile()->map().data() : nullptr),
        dark_cosine(Floats(static_cast<float>(falloff.dark_cosine()))),
        per_cosine(Floats(static_cast<float>(falloff.per_cosine()))),
        shape(falloff.shape()),
        has_cone(falloff.has_cone()) {}

  // In the unit direction w.
  [[nodiscard]] HWY_INLINE FloatVec Towards(const V3<FloatVec>& w) const {
    const FloatVec cosine = dot(w, axis);
    const FloatVec by_cosine = At(cosine);
    if (!profile) return by_cosine;
    return hn::Mul(by_cosine, ProfileAt(profile, dot(w, azimuth_0), dot(w, azimuth_90), cosine));
  }

  // At the cosine of the angle from the axis, but for a profile.
  [[nodiscard]] HWY_INLINE FloatVec At(FloatVec cosine) const {
    const FloatTag d;
    if (!has_cone) {
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
