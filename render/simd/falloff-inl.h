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

// A map at a place in its square, [-1, 1]^2.
HWY_INLINE FloatVec MapAt(const IntensityMap& map, const V2<FloatVec>& position) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  const float* values = map.values.data();
  const auto half = 0.5f * static_cast<float>(map.side - 1);
  const auto place = [&](FloatVec t) HWY_ATTR {
    const FloatVec in_cells = mul_add(t, half, half);
    return clamp(in_cells, 0.0f, 2.0f * half);
  };
  const FloatVec column = place(position.x);
  const FloatVec row = place(position.y);
  const auto last = hn::Set(di, map.side - 2);
  const auto low_column = min(hn::ConvertTo(di, column), last);
  const auto low_row = min(hn::ConvertTo(di, row), last);
  const FloatVec f = column - hn::ConvertTo(d, low_column);
  const FloatVec g = row - hn::ConvertTo(d, low_row);
  const auto first = low_row * map.side + low_column;
  const auto mix = [&](const float* at) HWY_ATTR {
    const FloatVec low = hn::GatherIndex(d, at, first);
    const FloatVec high = hn::GatherIndex(d, at + 1, first);
    return mul_add(f, high - low, low);
  };
  const FloatVec low = mix(values);
  return mul_add(g, mix(values + map.side) - low, low);
}

struct FalloffFloats {
  V3<FloatVec> axis;
  V3<FloatVec> azimuth_0, azimuth_90;  // of a cone
  const IntensityMap* map = nullptr;   // of a profile or a picture
  float cotangent = 0.0f;              // of a picture
  float dark_versine = 0.0f, per_versine = 0.0f;
  LightFalloff::Shape shape = LightFalloff::Shape::isotropic;
  bool has_cone = false;

  FalloffFloats() = default;
  HWY_INLINE explicit FalloffFloats(const LightFalloff& falloff)
      : axis(Floats(falloff.axis())),
        azimuth_0(Floats(falloff.azimuth_0())),
        azimuth_90(Floats(falloff.azimuth_90())),
        map(falloff.map().get()),
        cotangent(static_cast<float>(falloff.cotangent())),
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
    if (!map) return in_cone;
    return in_cone *
           MapAt(*map, map->is_around_cone ? cone_position(w, cotangent) : octahedral_position(w));
  }
};

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
