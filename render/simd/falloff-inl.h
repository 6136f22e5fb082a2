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

// PhotometricProfile::at() in the direction w, of any length but 0, by its map.
HWY_INLINE FloatVec ProfileAt(const float* map, const V3<FloatVec>& w) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  constexpr int side = PhotometricProfile::side;
  constexpr float half = 0.5f * (side - 1);
  const V2<FloatVec> position = octahedral_position(w);
  const auto place = [&](FloatVec t) HWY_ATTR {
    const FloatVec in_cells = mul_add(t, half, half);
    return clamp(in_cells, 0.0f, 2.0f * half);
  };
  const FloatVec column = place(position.x);
  const FloatVec row = place(position.y);
  const auto last = hn::Set(di, side - 2);
  const auto low_column = min(hn::ConvertTo(di, column), last);
  const auto low_row = min(hn::ConvertTo(di, row), last);
  const FloatVec f = column - hn::ConvertTo(d, low_column);
  const FloatVec g = row - hn::ConvertTo(d, low_row);
  const auto first = low_row * side + low_column;
  const auto mix = [&](const float* at) HWY_ATTR {
    const FloatVec low = hn::GatherIndex(d, at, first);
    const FloatVec high = hn::GatherIndex(d, at + 1, first);
    return mul_add(f, high - low, low);
  };
  const FloatVec low = mix(map);
  return mul_add(g, mix(map + side) - low, low);
}

struct FalloffFloats {
  V3<FloatVec> axis;
  V3<FloatVec> azimuth_0, azimuth_90;  // of a cone
  const float* profile = nullptr;      // map of a profile
  float dark_versine = 0.0f, per_versine = 0.0f;
  LightFalloff::Shape shape = LightFalloff::Shape::isotropic;
  bool has_cone = false;

  FalloffFloats() = default;
  HWY_INLINE explicit FalloffFloats(const LightFalloff& falloff)
      : axis(Floats(falloff.axis())),
        azimuth_0(Floats(falloff.azimuth_0())),
        azimuth_90(Floats(falloff.azimuth_90())),
        profile(falloff.profile() ? falloff.profile()->map().data() : nullptr),
        dark_versine(static_cast<float>(falloff.dark_versine())),
        per_versine(static_cast<float>(falloff.per_versine())),
        shape(falloff.shape()),
        has_cone(falloff.has_cone()) {}

  // The components of a vector, along the azimuths and the axis.
  [[nodiscard]] HWY_INLINE V3<FloatVec> Components(const V3<FloatVec>& v) const {
    return {dot(v, azimuth_0), dot(v, azimuth_90), dot(v, axis)};
  }

  // In the unit direction of these components. Without a cone, x and y do not matter.
  [[nodiscard]] HWY_INLINE FloatVec At(const V3<FloatVec>& w) const {
    if (!has_cone) {
      return min(shape == LightFalloff::Shape::two_cosines ? abs(w.z) : max(w.z, 0.0), 1.0);
    }
    const FloatVec in_cone = cone_falloff(w, dark_versine, per_versine);
    return profile ? in_cone * ProfileAt(profile, w) : in_cone;
  }
};

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
