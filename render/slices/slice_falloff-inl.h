// Falloff of lights over the slices of rays, in SIMD. Included once per instruction set by the
// files that Highway compiles for each.

#if defined(BRUME_SLICE_FALLOFF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_SLICE_FALLOFF_INL_H
#undef BRUME_SLICE_FALLOFF_INL_H
#else
#define BRUME_SLICE_FALLOFF_INL_H
#endif

#include <hwy/highway.h>

#include "render/simd/falloff-inl.h"
#include "render/slices/slice_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The falloff of a light as rays see it.
struct FalloffRays {
  // Components along a cone's azimuths, if there is one, and the axis: of the ray's direction, and
  // of its offset to the light. The direction from the light at s is (s along - across) / distance.
  V3<FloatVec> along, across;
  FalloffFloats falloff;
  FloatVec edges[4];  // parameters s, ascending, between which the falloff is smooth

  FalloffRays() = default;
  // `offset`: from the nearest point to the light; h2: its square, clamped.
  HWY_INLINE FalloffRays(const LightFalloff& of_light, const V3<FloatVec>& w,
                         const V3<FloatVec>& offset, FloatVec h2)
      : falloff(of_light) {
    // Edges are those of LightFalloff::edges(); missing ones are far away.
    constexpr float far = 1e30f;
    along = falloff.Components(w);
    across = falloff.Components(offset);
    if (!falloff.has_cone) {
      const FloatVec at_plane = select(along.z != 0.0f, across.z / along.z, far);
      edges[0] = clamp(at_plane, -far, far);
      edges[1] = edges[2] = edges[3] = Floats(far);
      return;
    }
    const float full_versine = falloff.dark_versine - 1.0f / falloff.per_versine;
    const V2<FloatVec> dark = cone_edges(along, across, h2, falloff.dark_versine, far);
    const V2<FloatVec> full = cone_edges(along, across, h2, full_versine, far);
    edges[0] = min(dark.x, dark.y);
    edges[1] = max(dark.x, dark.y);
    edges[2] = min(full.x, full.y);
    edges[3] = max(full.x, full.y);
    const auto sort = [&](int i, int j) HWY_ATTR {
      const FloatVec low = min(edges[i], edges[j]);
      edges[j] = max(edges[i], edges[j]);
      edges[i] = low;
    };
    sort(0, 2);
    sort(1, 3);
    sort(1, 2);
  }

  // The falloff of a profile in the direction from the light whose angle from the nearest point of
  // the ray, which is h away, has this sine and cosine.
  [[nodiscard]] HWY_INLINE FloatVec AtAngle(FloatVec sine, FloatVec cosine, FloatVec h) const {
    return falloff.At(mul_sub(sine, along, (cosine / h) * across));
  }

  // At s, the square of whose distance from the light is r2.
  [[nodiscard]] HWY_INLINE FloatVec At(FloatVec s, FloatVec r2) const {
    const FloatVec r = sqrt(r2);
    const auto component = [&](FloatVec a, FloatVec b) HWY_ATTR { return mul_sub(s, a, b) / r; };
    const FloatVec z = component(along.z, across.z);
    if (!falloff.has_cone) return falloff.At({z, z, z});
    return falloff.At({component(along.x, across.x), component(along.y, across.y), z});
  }
};

// The mean of a profile over the angle that a part of a ray spans at its light, which is how light
// arrives on it, and the place s at which it arrives on the mean. Where the angle is small they are
// left as they are.
HWY_INLINE void SampleProfile(const FalloffRays& light, FloatVec begin, FloatVec angle, FloatVec h2,
                              FloatVec& mean, FloatVec& place) {
  const FloatTag d;
  const auto is_wide = angle > 2.0f * profile_step;
  if (hn::AllFalse(d, is_wide)) return;
  const FloatVec h = sqrt(h2);
  // Each ray in its own steps, whatever its neighbours'.
  const FloatVec count = floor(angle * (1.0f / profile_step)) + 1.0f;
  const FloatVec step = angle / count;
  const FloatVec first = mul_add(0.5f, step, atan(begin / h));
  FloatVec sum = hn::Zero(d);
  FloatVec moment = hn::Zero(d);
  const auto most = static_cast<int>(hn::GetLane(hn::MaxOfLanes(d, count)));
  for (int i = 0; i < most; ++i) {
    const FloatVec index = Floats(static_cast<float>(i));
    const FloatVec theta = mul_add(index, step, first);
    const FloatVec sine = sin(theta);
    const FloatVec cosine = max(cos(theta), tiny);
    const FloatVec value = where(index < count, light.AtAngle(sine, cosine, h));
    sum += value;
    moment = mul_add(value, h * sine / cosine, moment);
  }
  const auto counts = hn::And(is_wide, sum > 0.0f);
  mean = select(is_wide, sum / count, mean);
  place = select(counts, moment / sum, place);
}

// The mean of the falloff over r^2 over s in [a, b], and the middle of what is lit of it.
struct FalloffMean {
  FloatVec value, center;

  HWY_INLINE FalloffMean(const FalloffRays& light, FloatVec a, FloatVec b, FloatVec h2) {
    const FloatTag d;
    const FloatVec zero = hn::Zero(d);
    FloatVec sum = zero;
    FloatVec moment = zero;
    const auto add = [&](FloatVec begin, FloatVec end) HWY_ATTR {
      const FloatVec width = end - begin;
      const auto is_long = width > zero;
      if (hn::AllFalse(d, is_long)) return;
      constexpr float weights[] = {gauss_3_end, gauss_3_middle, gauss_3_end};
      const FloatVec middle = 0.5f * (begin + end);
      const FloatVec half = 0.5f * width;
      FloatVec falloff = zero;
      FloatVec whole = zero;
      for (int i = 0; i < 3; ++i) {
        const FloatVec s = mul_add(gauss_3_place * static_cast<float>(i - 1), half, middle);
        const FloatVec r2 = mul_add(s, s, h2);
        const FloatVec weight = weights[i] / r2;
        falloff = mul_add(weight, light.At(s, r2), falloff);
        whole += weight;
      }
      const FloatVec unattenuated = mean_inverse_square(begin, end, h2) * width;
      FloatVec mean = falloff / whole;
      FloatVec place = middle;
      if (light.falloff.profile) {
        const FloatVec angle = where(is_long, unattenuated * sqrt(h2));
        SampleProfile(light, begin, angle, h2, mean, place);
        place = clamp(place, begin, end);
      }
      const FloatVec counted = where(is_long, unattenuated * mean);
      sum += counted;
      moment = mul_add(counted, place, moment);
    };
    auto has_edge = b < a;
    for (const FloatVec edge : light.edges) {
      has_edge = hn::Or(has_edge, hn::And(edge > a, edge < b));
    }
    if (hn::AllFalse(d, has_edge)) {
      add(a, b);
    } else {
      FloatVec begin = a;
      for (const FloatVec edge : light.edges) {
        const FloatVec end = clamp(edge, begin, b);
        add(begin, end);
        begin = end;
      }
      add(begin, b);
    }
    const auto is_lit = sum > zero;
    value = where(is_lit, sum / (b - a));
    center = select(is_lit, moment / sum, 0.5f * (a + b));
  }
};

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
