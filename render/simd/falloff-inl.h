// LightFalloff in SIMD. Included once per instruction set by the files that Highway compiles for
// each.

#if defined(BRUME_FALLOFF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_FALLOFF_INL_H
#undef BRUME_FALLOFF_INL_H
#else
#define BRUME_FALLOFF_INL_H
#endif

#include <hwy/highway.h>

#include "core/scene/lights/light_falloff.h"
#include "core/scene/lights/photometric_profile.h"
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
  V3<FloatVec> azimuth_0, azimuth_90;  // of a cone
  const float* profile = nullptr;      // map of a profile
  FloatVec dark_versine, per_versine;
  LightFalloff::Shape shape = LightFalloff::Shape::isotropic;
  bool has_cone = false;

  FalloffFloats() = default;
  HWY_INLINE explicit FalloffFloats(const LightFalloff& falloff)
      : axis(Floats(falloff.axis())),
        azimuth_0(Floats(falloff.azimuth_0())),
        azimuth_90(Floats(falloff.azimuth_90())),
        profile(falloff.profile() ? falloff.profile()->map().data() : nullptr),
        dark_versine(Floats(static_cast<float>(falloff.dark_versine()))),
        per_versine(Floats(static_cast<float>(falloff.per_versine()))),
        shape(falloff.shape()),
        has_cone(falloff.has_cone()) {}

  // In the unit direction w.
  [[nodiscard]] HWY_INLINE FloatVec Towards(const V3<FloatVec>& w) const {
    return At(dot(w, azimuth_0), dot(w, azimuth_90), dot(w, axis));
  }

  // In the unit direction of these components along the azimuths and the axis. Without a cone, x
  // and y do not matter.
  [[nodiscard]] HWY_INLINE FloatVec At(FloatVec x, FloatVec y, FloatVec z) const {
    const FloatTag d;
    const FloatVec zero = hn::Zero(d);
    const FloatVec one = Floats(1.0f);
    if (!has_cone) {
      const FloatVec positive =
          shape == LightFalloff::Shape::two_cosines ? hn::Abs(z) : hn::Max(z, zero);
      return hn::Min(positive, one);
    }
    // 1 - z, without cancellation near the axis.
    const FloatVec sine2 = hn::MulAdd(x, x, hn::Mul(y, y));
    const FloatVec versine =
        hn::IfThenElse(hn::Gt(z, zero), hn::Div(sine2, hn::Add(one, z)), hn::Sub(one, z));
    FloatVec share = hn::Mul(hn::Sub(dark_versine, versine), per_versine);
    share = hn::Min(hn::Max(share, zero), one);
    const FloatVec in_cone = hn::Mul(share, share);
    return profile ? hn::Mul(in_cone, ProfileAt(profile, x, y, z)) : in_cone;
  }
};

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
