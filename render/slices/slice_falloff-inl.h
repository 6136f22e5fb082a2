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

  // Calls add(begin, end) for the parts of [a, b] between the edges.
  template <class Add>
  HWY_INLINE void EachSmoothPart(FloatVec a, FloatVec b, Add add) const {
    auto has_edge = b < a;
    for (const FloatVec edge : edges) {
      has_edge = hn::Or(has_edge, hn::And(edge > a, edge < b));
    }
    FloatVec begin = a;
    if (!hn::AllFalse(FloatTag(), has_edge)) {
      for (const FloatVec edge : edges) {
        const FloatVec end = clamp(edge, begin, b);
        add(begin, end);
        begin = end;
      }
    }
    add(begin, b);
  }

  // Panels of AnglesOfPart over which the falloff is smooth between the edges [radians].
  [[nodiscard]] HWY_INLINE float Panel() const {
    if (!falloff.map) return falloff_panel;
    return falloff.map->is_around_cone ? picture_panel / falloff.cotangent : profile_panel;
  }

  // The falloff in the direction from the light whose angle from the nearest point of the ray,
  // which is h away, has this sine and cosine.
  [[nodiscard]] HWY_INLINE FloatVec AtAngle(FloatVec sine, FloatVec cosine, FloatVec h) const {
    return falloff.At(mul_sub(sine, along, (cosine / h) * across));
  }

  // The integral of a cosine over r^2 between two s on one side of its plane.
  [[nodiscard]] HWY_INLINE FloatVec OfCosineBetween(FloatVec begin, FloatVec end,
                                                    FloatVec h2) const {
    const FloatVec sum =
        cosine_integral(along.z, across.z, h2, end) - cosine_integral(along.z, across.z, h2, begin);
    return falloff.shape == LightFalloff::Shape::two_cosines ? abs(sum) : max(sum, 0.0f);
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

// A part of a ray as the light that it is h away from sees it: light arrives evenly over the angle.
struct AnglesOfPart {
  FloatVec first, angle;

  HWY_INLINE AnglesOfPart(FloatVec begin, FloatVec end, FloatVec distance)
      : first(atan(begin / distance)), angle(atan(end / distance) - first) {}

  // Integrates over the angle by Gauss' rule on panels no wider than `panel`: add(weight, sine,
  // cosine) for each node, as of the nearest point. For lanes where the angle is positive.
  template <class Add>
  HWY_INLINE void Integrate(float panel, Add add) const {
    const FloatTag d;
    constexpr float weights[] = {gauss_3_end, gauss_3_middle, gauss_3_end};
    // Each ray has its own panels, whatever its neighbours have.
    const FloatVec count = floor(max(angle, 0.0f) * (1.0f / panel)) + 1.0f;
    const FloatVec step = max(angle, 0.0f) / count;
    const auto most = static_cast<int>(hn::GetLane(hn::MaxOfLanes(d, count)));
    for (int i = 0; i < most; ++i) {
      const FloatVec index = Floats(static_cast<float>(i));
      const FloatVec width = where(index < count, step);
      const FloatVec middle = mul_add(index + 0.5f, step, first);
      for (int k = 0; k < 3; ++k) {
        const FloatVec theta =
            mul_add(0.5f * gauss_3_place * static_cast<float>(k - 1), step, middle);
        add(weights[k] * width, sin(theta), max(cos(theta), tiny));
      }
    }
  }
};

// The mean of the falloff over r^2 over s in [a, b], and the middle of what is lit of it. `angle`:
// how much [a, b] spans at the light.
struct FalloffMean {
  FloatVec value, center, angle;

  HWY_INLINE FalloffMean(const FalloffRays& light, FloatVec a, FloatVec b, FloatVec h2) {
    const FloatTag d;
    const FloatVec zero = hn::Zero(d);
    FloatVec sum = zero;
    FloatVec moment = zero;
    const FloatVec h = sqrt(h2);
    const float panel = light.Panel();
    angle = mean_inverse_square(a, b, h2) * (b - a) * h;
    const auto is_wide = angle > wide_falloff * panel;
    light.EachSmoothPart(a, b, [&](FloatVec begin, FloatVec end) HWY_ATTR {
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
      FloatVec arriving = unattenuated * falloff / whole;
      if (!light.falloff.has_cone) {
        arriving = select(is_wide, light.OfCosineBetween(begin, end, h2), arriving);
      }
      const FloatVec counted = where(is_long, arriving);
      sum += counted;
      moment = mul_add(counted, middle, moment);
    });
    if (light.falloff.has_cone && !hn::AllFalse(d, is_wide)) {
      FloatVec seen = zero;
      FloatVec seen_moment = zero;
      light.EachSmoothPart(a, b, [&](FloatVec begin, FloatVec end) HWY_ATTR {
        AnglesOfPart(begin, end, h)
            .Integrate(panel, [&](FloatVec weight, FloatVec sine, FloatVec cosine) HWY_ATTR {
              const FloatVec arriving = weight * light.AtAngle(sine, cosine, h);
              seen += arriving;
              seen_moment = mul_add(arriving, h * sine / cosine, seen_moment);
            });
      });
      sum = select(is_wide, seen / h, sum);
      moment = select(is_wide, seen_moment / h, moment);
    }
    const auto is_lit = sum > zero;
    value = where(is_lit, sum / (b - a));
    center = select(is_lit, clamp(moment / max(sum, tiny), a, b), 0.5f * (a + b));
  }
};

// The mean over s in [a, b], which spans a wide angle at the light, of the falloff, 1 where `light`
// is null, over r^2 times scattered(cosine of the angle by which light turns to the eye).
template <class Scattered>
HWY_INLINE FloatVec MeanOfWidePart(const FalloffRays* light, FloatVec a, FloatVec b, FloatVec h2,
                                   float panel, Scattered scattered) {
  const FloatVec h = sqrt(h2);
  FloatVec sum = hn::Zero(FloatTag());
  const auto add = [&](FloatVec begin, FloatVec end) HWY_ATTR {
    AnglesOfPart(begin, end, h)
        .Integrate(panel, [&](FloatVec weight, FloatVec sine, FloatVec cosine) HWY_ATTR {
          if (light) weight *= light->AtAngle(sine, cosine, h);
          sum = mul_add(weight, scattered(-sine), sum);
        });
  };
  if (light) {
    light->EachSmoothPart(a, b, add);
  } else {
    add(a, b);
  }
  return sum / max(h * (b - a), tiny);
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
