// Falloff of lights over the slices of rays, in SIMD. Included once per instruction set by the
// files that Highway compiles for each.

#if defined(BRUME_SLICE_FALLOFF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_SLICE_FALLOFF_INL_H
#undef BRUME_SLICE_FALLOFF_INL_H
#else
#define BRUME_SLICE_FALLOFF_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <numbers>

#include "render/simd/falloff-inl.h"
#include "render/slices/slice_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The mean of 1 / r^2 over t in [ts + a, ts + b], b > a, for a light at distance h from the ray:
// the angle that the slice spans at the light, divided by h (b - a).
HWY_INLINE FloatVec MeanInverseSquare(FloatVec a, FloatVec b, FloatVec h2) {
  const FloatTag d;
  const FloatVec width = hn::Sub(b, a);
  const FloatVec dots = hn::MulAdd(a, b, h2);
  const FloatVec h = hn::Sqrt(h2);
  const FloatVec crosses = hn::Mul(h, width);
  const FloatVec ratio = hn::Div(crosses, dots);
  const auto small =
      hn::And(hn::Gt(dots, hn::Zero(d)), hn::Lt(ratio, Floats(coefficient::atan_small_end)));
  const FloatVec near_one = Horner(d, hn::Mul(ratio, ratio), coefficient::atan_small);
  const FloatVec direct = hn::Div(near_one, hn::Max(dots, Floats(coefficient::tiny)));
  if (hn::AllTrue(d, small)) return direct;
  const FloatVec acute =
      hn::Atan(d, hn::Div(crosses, hn::Max(hn::Abs(dots), Floats(coefficient::tiny))));
  const FloatVec angle = hn::IfThenElse(hn::Ge(dots, hn::Zero(d)), acute,
                                        hn::Sub(Floats(std::numbers::pi_v<float>), acute));
  const FloatVec wide = hn::Div(angle, hn::Max(crosses, Floats(coefficient::tiny)));
  return hn::IfThenElse(small, direct, wide);
}

// The falloff of a light as rays see it.
struct FalloffRays {
  // Cosine from the axis at s from the nearest point: (s along - across) / distance.
  FloatVec along, across;
  // The same of a cone's azimuths.
  FloatVec along_0, across_0, along_90, across_90;
  FalloffFloats falloff;
  FloatVec edges[4];  // parameters s, ascending, between which the falloff is smooth

  FalloffRays() = default;
  // `offset`: from the nearest point to the light; h2: its square, clamped.
  HWY_INLINE FalloffRays(const LightFalloff& of_light, const V3<FloatVec>& w,
                         const V3<FloatVec>& offset, FloatVec h2)
      : falloff(of_light) {
    const FloatTag d;
    along = dot(w, falloff.axis);
    across = dot(offset, falloff.axis);
    if (falloff.has_cone) {
      along_0 = dot(w, falloff.azimuth_0);
      across_0 = dot(offset, falloff.azimuth_0);
      along_90 = dot(w, falloff.azimuth_90);
      across_90 = dot(offset, falloff.azimuth_90);
    }
    // As LightFalloff::edges() has them; those that are missing are far away.
    const FloatVec far = Floats(1e30f);
    if (!falloff.has_cone) {
      const FloatVec at_plane =
          hn::IfThenElse(hn::Ne(along, hn::Zero(d)), hn::Div(across, along), far);
      edges[0] = hn::Max(hn::Min(at_plane, far), hn::Neg(far));
      edges[1] = edges[2] = edges[3] = far;
      return;
    }
    // sine^2 (s^2 + h2) = |(s along_0 - across_0, s along_90 - across_90)|^2, by sines, which keep
    // their digits where the cone is narrow.
    const FloatVec along2 = hn::MulAdd(along_0, along_0, hn::Mul(along_90, along_90));
    const FloatVec b = hn::MulAdd(along_0, across_0, hn::Mul(along_90, across_90));
    const FloatVec across2 = hn::MulAdd(across_0, across_0, hn::Mul(across_90, across_90));
    const FloatVec cross = hn::MulSub(along_0, across_90, hn::Mul(along_90, across_0));
    std::size_t count = 0;
    const FloatVec slope = hn::Div(Floats(1.0f), falloff.per_versine);
    for (const FloatVec versine : {falloff.dark_versine, hn::Sub(falloff.dark_versine, slope)}) {
      const FloatVec sine2 = hn::Mul(versine, hn::Sub(Floats(2.0f), versine));
      const FloatVec a = hn::Sub(sine2, along2);
      const FloatVec c = hn::MulSub(sine2, h2, across2);
      // b^2 - a c
      const FloatVec square =
          hn::NegMulAdd(cross, cross, hn::Mul(sine2, hn::NegMulAdd(a, h2, across2)));
      const auto meets = hn::Ge(square, hn::Zero(d));
      const FloatVec root = hn::Sqrt(hn::Max(square, hn::Zero(d)));
      const FloatVec sum = hn::Neg(hn::Add(b, hn::CopySign(root, b)));
      const auto ratio = [&](FloatVec x, FloatVec y) HWY_ATTR {
        const auto is_finite = hn::And(meets, hn::Ne(y, hn::Zero(d)));
        const FloatVec value = hn::IfThenElse(is_finite, hn::Div(x, y), far);
        return hn::Max(hn::Min(value, far), hn::Neg(far));
      };
      edges[count++] = ratio(sum, a);
      edges[count++] = ratio(c, sum);
    }
    const auto sort = [&](int i, int j) HWY_ATTR {
      const FloatVec low = hn::Min(edges[i], edges[j]);
      edges[j] = hn::Max(edges[i], edges[j]);
      edges[i] = low;
    };
    sort(0, 1);
    sort(2, 3);
    sort(0, 2);
    sort(1, 3);
    sort(1, 2);
  }

  // Of a profile, in the direction from the light whose angle from the nearest point of the ray,
  // which is h away, has this sine and cosine.
  [[nodiscard]] HWY_INLINE FloatVec AtAngle(FloatVec sine, FloatVec cosine, FloatVec h) const {
    const FloatVec to_nearest = hn::Div(cosine, h);
    const auto component = [&](FloatVec along_, FloatVec across_) HWY_ATTR {
      return hn::MulSub(sine, along_, hn::Mul(to_nearest, across_));
    };
    return falloff.At(component(along_0, across_0), component(along_90, across_90),
                      component(along, across));
  }

  // At s, the square of whose distance from the light is r2.
  [[nodiscard]] HWY_INLINE FloatVec At(FloatVec s, FloatVec r2) const {
    const FloatVec r = hn::Sqrt(r2);
    const FloatVec z = hn::Div(hn::MulSub(s, along, across), r);
    if (!falloff.has_cone) return falloff.At(z, z, z);
    return falloff.At(hn::Div(hn::MulSub(s, along_0, across_0), r),
                      hn::Div(hn::MulSub(s, along_90, across_90), r), z);
  }
};

// The mean of a profile over the angle that a part of a ray spans at its light, which is how light
// arrives on it, and the place s at which it arrives on the mean. Where the angle is small they are
// left as they are.
HWY_INLINE void SampleProfile(const FalloffRays& light, FloatVec begin, FloatVec angle, FloatVec h2,
                              FloatVec& mean, FloatVec& place) {
  const FloatTag d;
  const auto is_wide = hn::Gt(angle, Floats(2.0f * profile_step));
  if (hn::AllFalse(d, is_wide)) return;
  const FloatVec h = hn::Sqrt(h2);
  // Each ray in its own steps, whatever its neighbours'.
  const FloatVec count =
      hn::Add(hn::Floor(hn::Mul(angle, Floats(1.0f / profile_step))), Floats(1.0f));
  const FloatVec step = hn::Div(angle, count);
  const FloatVec first = hn::MulAdd(Floats(0.5f), step, hn::Atan(d, hn::Div(begin, h)));
  FloatVec sum = hn::Zero(d);
  FloatVec moment = hn::Zero(d);
  const auto most = static_cast<int>(hn::GetLane(hn::MaxOfLanes(d, count)));
  for (int i = 0; i < most; ++i) {
    const FloatVec index = Floats(static_cast<float>(i));
    const FloatVec at = hn::MulAdd(index, step, first);
    const FloatVec sine = hn::Sin(d, at);
    const FloatVec cosine = hn::Max(hn::Cos(d, at), Floats(coefficient::tiny));
    const FloatVec value = hn::IfThenElseZero(hn::Lt(index, count), light.AtAngle(sine, cosine, h));
    sum = hn::Add(sum, value);
    moment = hn::MulAdd(value, hn::Div(hn::Mul(h, sine), cosine), moment);
  }
  const auto counts = hn::And(is_wide, hn::Gt(sum, hn::Zero(d)));
  mean = hn::IfThenElse(is_wide, hn::Div(sum, count), mean);
  place = hn::IfThenElse(counts, hn::Div(moment, sum), place);
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
      const FloatVec width = hn::Sub(end, begin);
      const auto is_long = hn::Gt(width, zero);
      if (hn::AllFalse(d, is_long)) return;
      constexpr float weights[] = {gauss_3_end, gauss_3_middle, gauss_3_end};
      const FloatVec middle = hn::Mul(Floats(0.5f), hn::Add(begin, end));
      const FloatVec half = hn::Mul(Floats(0.5f), width);
      FloatVec falloff = zero;
      FloatVec whole = zero;
      for (int i = 0; i < 3; ++i) {
        const FloatVec s =
            hn::MulAdd(Floats(gauss_3_place * static_cast<float>(i - 1)), half, middle);
        const FloatVec r2 = hn::MulAdd(s, s, h2);
        const FloatVec weight = hn::Div(Floats(weights[i]), r2);
        falloff = hn::MulAdd(weight, light.At(s, r2), falloff);
        whole = hn::Add(whole, weight);
      }
      const FloatVec unattenuated = hn::Mul(MeanInverseSquare(begin, end, h2), width);
      FloatVec mean = hn::Div(falloff, whole);
      FloatVec place = middle;
      if (light.falloff.profile) {
        const FloatVec angle = hn::IfThenElseZero(is_long, hn::Mul(unattenuated, hn::Sqrt(h2)));
        SampleProfile(light, begin, angle, h2, mean, place);
        place = hn::Min(hn::Max(place, begin), end);
      }
      const FloatVec counted = hn::IfThenElseZero(is_long, hn::Mul(unattenuated, mean));
      sum = hn::Add(sum, counted);
      moment = hn::MulAdd(counted, place, moment);
    };
    auto has_edge = hn::Lt(b, a);
    for (const FloatVec edge : light.edges) {
      has_edge = hn::Or(has_edge, hn::And(hn::Gt(edge, a), hn::Lt(edge, b)));
    }
    if (hn::AllFalse(d, has_edge)) {
      add(a, b);
    } else {
      FloatVec begin = a;
      for (const FloatVec edge : light.edges) {
        const FloatVec end = hn::Min(hn::Max(edge, begin), b);
        add(begin, end);
        begin = end;
      }
      add(begin, b);
    }
    const auto is_lit = hn::Gt(sum, zero);
    value = hn::IfThenElseZero(is_lit, hn::Div(sum, hn::Sub(b, a)));
    center = hn::IfThenElse(is_lit, hn::Div(moment, sum), hn::Mul(Floats(0.5f), hn::Add(a, b)));
  }
};

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
