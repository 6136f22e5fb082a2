#include "render/slices/slice_kernels.h"

#include <algorithm>
#include <cmath>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/slices/slice_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/gaussian-inl.h"
#include "render/simd/view_rays-inl.h"
#include "render/slices/slice_falloff-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using Vector = V3<V>;

HWY_INLINE V set(float x) {
  return hn::Set(D(), x);
}

// A place between four cells of a table.
struct Bilinear {
  hn::Vec<hn::RebindToSigned<D>> cell;  // the first of them
  V fx, fy;                             // from 0 to 1 among them

  // Between cells of a row, and from row to row.
  HWY_INLINE Bilinear(V x, V y, int stride) {
    const D d;
    const hn::RebindToSigned<D> di;
    const auto xi = hn::ConvertTo(di, x);
    const auto yi = hn::ConvertTo(di, y);
    fx = x - hn::ConvertTo(d, xi);
    fy = y - hn::ConvertTo(d, yi);
    cell = yi * stride + xi;
  }

  // The mix of value(cell offset) over the four cells.
  template <class Value>
  HWY_INLINE V Mix(int stride, Value value) const {
    const auto mix = [](V low, V high, V f) HWY_ATTR { return mul_add(f, high - low, low); };
    return mix(mix(value(0), value(1), fx), mix(value(stride), value(stride + 1), fx), fy);
  }
};

// The place of q in a table over a map, border included, from a point whose components in a
// perspective map are `origin`; `distance`: from the light.
HWY_INLINE Bilinear MapPosition(const DirectionMap& map, const Vector& q, const glm::vec3& origin,
                                V distance) {
  V2<V> position;
  if (map.octahedral) {
    position = octahedral_position(q);
  } else {
    const auto along = [&](const glm::vec3& axis, float start) HWY_ATTR {
      return dot(q, Vector{set(axis.x), set(axis.y), set(axis.z)}) + start;
    };
    // Behind the light there is nothing of interest; clamped to the map's border texel.
    const V depth = max(along(map.axis, origin.z), DirectionMap::min_cosine * distance);
    const V inverse = 1.0 / max(depth, tiny);
    position = {mul_add(along(map.right, origin.x) * inverse, map.scale.x, map.offset.x),
                mul_add(along(map.up, origin.y) * inverse, map.scale.y, map.offset.y)};
  }
  // In cells, counted from the middle of the border cell.
  const auto in_cells = [&](V along, int count) HWY_ATTR {
    const auto cells = static_cast<float>(count);
    const V x = mul_add(along, 0.5f * cells, 0.5f * cells + 0.5f);
    return clamp(x, 0.0f, cells + DirectionMap::border_share);
  };
  return {in_cells(position.x, map.columns), in_cells(position.y, map.rows), map.stride()};
}

// The depth of a table at q from `origin`, see MapPosition.
HWY_INLINE V Lookup(const OpticalDepthTable::View& table, const Vector& q, const glm::vec3& origin,
                    V distance) {
  const D d;
  const hn::RebindToSigned<D> di;
  const Bilinear position = MapPosition(table.map, q, origin, distance);
  const V beyond = max(distance - table.first_radius, 0.0f);
  V r = beyond * table.radii_per_unit;
  if (table.curvature > 0.0f) r /= mul_add(table.curvature, beyond, 1.0f);
  r = min(r, static_cast<float>(table.radii) - table_end);
  const auto ri = hn::ConvertTo(di, r);
  const V fr = r - hn::ConvertTo(d, ri);
  const auto first = position.cell * table.radii + ri;
  // Two neighbours of 16 bits come in one gather.
  const auto* pairs = reinterpret_cast<const std::int32_t*>(table.depths);
  const V depth = position.Mix(table.map.stride(), [&](int cell) HWY_ATTR {
    const auto index = first + cell * table.radii;
    const auto both = hn::GatherOffset(di, pairs, hn::ShiftLeft<1>(index));
    const V near = hn::ConvertTo(d, hn::And(both, hn::Set(di, 0xffff)));
    const V far = hn::ConvertTo(
        d, hn::BitCast(di, hn::ShiftRight<16>(hn::BitCast(hn::RebindToUnsigned<D>(), both))));
    return mul_add(fr, far - near, near);
  });
  return depth * table.unit;
}

void LookupDepths(const OpticalDepthTable::View& table, const PathBatch& paths, float* depths) {
  const D d;
  for (std::size_t i = 0; i < paths.padded_size(); i += hn::Lanes(d)) {
    const V distance = hn::LoadU(d, paths.length.data() + i);
    const Vector q{distance * hn::LoadU(d, paths.x.data() + i),
                   distance * hn::LoadU(d, paths.y.data() + i),
                   distance * hn::LoadU(d, paths.z.data() + i)};
    hn::StoreU(Lookup(table, q, glm::vec3(0.0f), distance), d, depths + i);
  }
}

// The share of light that panes let through, bilinear as below.
HWY_INLINE V Passing(const ShadowMap& shadows, const Bilinear& position, V near) {
  const D d;
  V share = set(1.0f);
  for (const ShadowMap::PaneLayer& layer : shadows.panes()) {
    share *= position.Mix(shadows.map().stride(), [&](int cell) HWY_ATTR {
      const V depth = hn::GatherIndex(d, layer.depths.data(), position.cell + cell);
      const V passing = hn::GatherIndex(d, layer.passing.data(), position.cell + cell);
      return where(near <= depth, set(1.0f)) + where(near > depth, passing);
    });
  }
  return share;
}

// Visibility, bilinear over four cells (percentage-closer filtering).
HWY_INLINE V Lit(const SliceLight& light, const Vector& q, V distance) {
  const D d;
  const ShadowMap& shadows = *light.shadows;
  const DirectionMap& map = shadows.map();
  const Bilinear position = MapPosition(map, q, light.in_shadows, distance);
  const V depth =
      map.octahedral
          ? distance
          : dot(q, Vector{set(map.axis.x), set(map.axis.y), set(map.axis.z)}) + light.shadow_depth;
  // Slope bias of the shadow map: avoids self-shadowing.
  const V near = neg_mul_add(distance, shadow_bias(map), depth);
  // Mostly all four cells agree.
  const float* const ranges = &shadows.ranges()->min_depth;
  const auto range = hn::ShiftLeft<1>(position.cell);
  const auto lit = near <= hn::GatherIndex(d, ranges, range);
  if (hn::AllTrue(d, lit)) return set(1.0f);
  const auto dark = near > hn::GatherIndex(d, ranges, range + 1);
  if (hn::AllTrue(d, hn::Or(lit, dark))) return where(lit, set(1.0f));
  return Passing(shadows, position, near) *
         position.Mix(shadows.map().stride(), [&](int cell) HWY_ATTR {
           const V occluder_depth = hn::GatherIndex(d, shadows.depths(), position.cell + cell);
           return where(near <= occluder_depth, set(1.0f));
         });
}

// SliceWeights::along_rays: where the Gaussians have the depth G(t) on the ray, the integral of
// (G' + b0) exp(-(1 -+ e) G - (1 -+ f) b0 t) dt, + for light from the eye, e and f its extinction.
// The exponent grows evenly within a slice.
template <class Rays>
HWY_INLINE void SumAlongRays(const PathBatch& paths, const RaySlices& slices, std::size_t stride,
                             const float* increments, const SliceScattering& scattering,
                             const SliceWeights& weights, bool has_optics, const BatchFog& fog,
                             bool running) {
  const D d;
  // The first optics have the albedo.
  const std::size_t to_scattered = has_optics ? (slices.count() - 1) * stride : 0;
  const float from_eye = scattering.anisotropy < 0.0f ? 1.0f : -1.0f;
  const V per_depth = set(1.0f + from_eye * weights.extinction);
  const float per_length = fog.density * (1.0f + from_eye * weights.fog_extinction);
  float* const sums = weights.along_rays;
  for (std::size_t i = 0; i < stride; i += hn::Lanes(d)) {
    const FogInterval<V> in_fog = FogOnRays(Rays(d, paths, i), fog);
    V begin = hn::LoadU(d, slices.at(i, 0));
    V transmittance_in = exp(-per_length * fog_overlap(in_fog, hn::Zero(d), begin));
    V sum = hn::Zero(d);
    for (std::size_t k = 0; k + 1 < slices.count(); ++k) {
      const V end = hn::LoadU(d, slices.at(i, k + 1));
      const V length = fog_overlap(in_fog, begin, end);
      const V gaussians = max(hn::LoadU(d, increments + k * stride + i), 0.0f);
      const V exponent = mul_add(per_depth, gaussians, per_length * length);
      const V transmittance_out = transmittance_in * exp(-exponent);
      const V mean = mean_transmittance(exponent, transmittance_in, transmittance_out);
      const V scattered = max(hn::LoadU(d, increments + to_scattered + k * stride + i), 0.0f);
      sum = mul_add(mean, scattered + fog.density * length, sum);
      if (running) hn::StoreU(sum, d, sums + k * stride + i);
      transmittance_in = transmittance_out;
      begin = end;
    }
    if (!running) hn::StoreU(sum, d, sums + i);
  }
}

// FogBall::length() from a point on a ray.
template <class Rays>
HWY_INLINE V FogLength(const SliceLight& light, V t, const Rays& rays, V distance) {
  const Vector q = FromPosition(rays, t, light.position);
  const Vector p = FromPosition(rays, t, light.fog_center);
  return fog_length(p, -(dot(p, q) / distance), distance, light.fog_radius);
}

HWY_INLINE V TruncatedPhase(const SliceScattering& scattering, V cosine) {
  const auto& power = scattering.truncated_phase;
  V sum = set(power[3]);
  for (std::size_t i = 3; i-- > 0;) sum = mul_add(sum, cosine, power[i]);
  return sum;
}

// The value of a LobeBroadening's table, bilinear.
HWY_INLINE V LobeLoss(const float* table, V cosine, V depth) {
  const D d;
  constexpr auto angles = static_cast<float>(LobeBroadening::angles);
  constexpr auto depths = static_cast<float>(LobeBroadening::depths);
  const V half_sine_2 = neg_mul_add(0.5f, cosine, 0.5f);
  const V angle = (angles - 1.0f) * sqrt(max(half_sine_2, 0.0f));
  const V share = depth / (depth + LobeBroadening::depth_scale);
  const V x = min(angle, angles - table_end);
  const V y = min(share * depths, depths - table_end);
  const Bilinear place(y, x, LobeBroadening::depths);
  return place.Mix(LobeBroadening::depths, [&](int offset) HWY_ATTR {
    return hn::GatherIndex(d, table, place.cell + offset);
  });
}

template <class Rays>
HWY_INLINE void SumSlicesOf(const PathBatch& paths, const RaySlices& slices,
                            const float* increments, const float* moments, const BatchFog& fog,
                            const SliceScattering& scattering, float negligible,
                            std::span<const SliceLight> lights, float* depths,
                            const SliceWeights& weights, const SliceOptics& optics,
                            const std::array<float*, light_pack>& radiance, SliceSums sums) {
  const D d;
  const bool running = sums == SliceSums::running;
  const V zero = hn::Zero(d);
  const std::size_t stride = paths.padded_size();
  const std::size_t plane = (slices.count() - 1) * stride;
  if (weights.along_rays) {
    SumAlongRays<Rays>(paths, slices, stride, increments, scattering, weights, optics.has, fog,
                       running);
  }
  const bool has_view_extinction = scattering.view_extinction != 1.0f;
  const V view_extinction = set(scattering.view_extinction);
  const float panel = phase_panel * (1.0f - std::abs(scattering.anisotropy));
  const V min_wide_angle = set(wide_phase * panel);
  std::array<OpticalDepthTable::View, light_pack> tables{};
  for (std::size_t l = 0; l < lights.size(); ++l) {
    if (lights[l].table && !lights[l].table->empty()) tables[l] = lights[l].table->view();
  }
  for (std::size_t i = 0; i < stride; i += hn::Lanes(d)) {
    const Rays rays(d, paths, i);
    const Vector& w = rays.w;
    const FogInterval<V> in_fog = FogOnRays(rays, fog);
    V ts[light_pack];
    V h2[light_pack];
    V sum[light_pack];
    FalloffRays falloffs[light_pack];
    for (std::size_t l = 0; l < lights.size(); ++l) {
      const glm::vec3& position = lights[l].position;
      const Vector s = rays.From({set(position.x), set(position.y), set(position.z)});
      ts[l] = dot(s, w);
      const Vector offset = neg_mul_add(ts[l], w, s);
      h2[l] = max(dot(offset, offset),
                  std::max(lights[l].h_min * lights[l].h_min, static_cast<float>(tiny)));
      sum[l] = zero;
      if (!lights[l].falloff.is_isotropic())
        falloffs[l] = FalloffRays(lights[l].falloff, w, offset, h2[l]);
    }
    V depth = zero;
    V begin = hn::LoadU(d, slices.at(i, 0));
    V emitted[3] = {zero, zero, zero};
    V weight = zero;       // of a look-up
    V lobe_weight = zero;  // of what a forward lobe scatters
    V weighted_distance = zero;
    for (std::size_t k = 0; k + 1 < slices.count(); ++k) {
      const V end = hn::LoadU(d, slices.at(i, k + 1));
      const V width = fog_overlap(in_fog, begin, end);
      const V gaussians = max(hn::LoadU(d, increments + k * stride + i), zero);
      const V increment = mul_add(fog.density, width, gaussians);
      const V next_depth = depth + increment;
      const auto matters = hn::And(increment > negligible, view_extinction * depth < visible_depth);
      if (!hn::AllFalse(d, matters)) {
        V whole_fraction = scattered_fraction(depth, increment);
        V truncated_fraction =
            has_view_extinction
                ? scattered_fraction(view_extinction * depth, view_extinction * increment) /
                      view_extinction
                : whole_fraction;
        if (optics.has) {
          const float* const own = increments + plane + k * stride + i;
          const V inverse = 1.0f / max(increment, tiny);
          const V emitting = where(matters, whole_fraction * inverse);
          for (std::size_t c = 0; c < 3 && optics.emission[c]; ++c) {
            const V emission = max(hn::LoadU(d, own + (c + 1) * plane), zero);
            emitted[c] = mul_add(emitting, emission, emitted[c]);
          }
          const V scattering_depth = mul_add(fog.density, width, max(hn::LoadU(d, own), zero));
          const V albedo = scattering_depth * inverse;
          whole_fraction *= albedo;
          truncated_fraction *= albedo;
        }
        // The slice holds fog evenly, as far as that goes.
        const V middle_of_fog = 0.5f * (max(begin, in_fog.begin) + min(end, in_fog.end));
        const V fog_moment = fog.density * width * middle_of_fog;
        const V moment = fog_moment + hn::LoadU(d, moments + k * stride + i);
        const LitPart<V> part = lit_part(begin, end, increment, moment);
        const V counted = where(matters, truncated_fraction);
        weight += counted;
        lobe_weight += where(matters, whole_fraction);
        weighted_distance = mul_add(counted, part.center, weighted_distance);
        for (std::size_t l = 0; l < lights.size(); ++l) {
          const V first = part.center - part.half_length - ts[l];
          const V last = part.center + part.half_length - ts[l];
          V falloff;
          V middle = part.center;
          V angle = zero;  // that the slice spans at the light
          if (lights[l].falloff.is_isotropic()) {
            falloff = mean_inverse_square(first, last, h2[l]);
            if (scattering.anisotropy != 0.0f) angle = falloff * (last - first) * sqrt(h2[l]);
          } else {
            const FalloffMean segment(falloffs[l], first, last, h2[l]);
            if (hn::AllFalse(d, segment.value > zero)) continue;
            falloff = segment.value;
            middle = ts[l] + segment.center;
            angle = segment.angle;
          }
          const V along = middle - ts[l];
          const V distance = sqrt(mul_add(along, along, h2[l]));
          const Vector q = FromPosition(rays, middle, lights[l].map_origin);
          V light_depth = fog.density * (lights[l].fog_radius > 0.0f
                                             ? FogLength(lights[l], middle, rays, distance)
                                             : distance);
          if (tables[l].depths) {
            light_depth += Lookup(tables[l], q, lights[l].in_table, distance);
          }
          V light = exp(light_depth * -lights[l].extinction);
          if (lights[l].shadows) light *= Lit(lights[l], q, distance);
          V scattered = falloff * whole_fraction;
          if (scattering.anisotropy != 0.0f) {
            const auto scattered_by = [&](V cosine) HWY_ATTR {
              V phase = henyey_greenstein(cosine, scattering.anisotropy);
              if (scattering.lobe_broadening) {
                const V path = mul_add(0.5f, increment, depth + light_depth);
                phase -= LobeLoss(scattering.lobe_broadening, cosine, scattering.albedo * path);
              }
              if (!has_view_extinction) return whole_fraction * phase;
              const V more = truncated_fraction - whole_fraction;
              return mul_add(more, TruncatedPhase(scattering, cosine), whole_fraction * phase);
            };
            scattered = falloff * scattered_by(cos_theta(along, distance));
            const auto is_wide = hn::And(hn::And(angle > min_wide_angle, falloff > zero), matters);
            if (!hn::AllFalse(d, is_wide)) {
              const bool is_isotropic = lights[l].falloff.is_isotropic();
              const V mean = MeanOfWidePart(
                  is_isotropic ? nullptr : &falloffs[l], first, last, h2[l],
                  is_isotropic ? panel : std::min(panel, falloffs[l].Panel()), scattered_by);
              scattered = select(is_wide, mean, scattered);
            }
          }
          sum[l] += where(matters, scattered * light);
        }
      }
      if (weights.lookups && ((k + 1) % slices_per_lookup == 0 || k + 2 == slices.count())) {
        const std::size_t place = k / slices_per_lookup * stride + i;
        hn::StoreU(weight, d, weights.lookups + place);
        hn::StoreU(lobe_weight, d, weights.lobe_lookups + place);
        hn::StoreU(weighted_distance / max(weight, tiny), d, weights.lookup_distances + place);
        weight = zero;
        lobe_weight = zero;
        weighted_distance = zero;
      }
      if (running) {
        const std::size_t place = k * stride + i;
        for (std::size_t c = 0; c < 3 && optics.emission[c]; ++c) {
          hn::StoreU(emitted[c], d, optics.emission[c] + place);
        }
        for (std::size_t l = 0; l < lights.size(); ++l) {
          hn::StoreU(isotropic_phase * sum[l], d, radiance[l] + place);
        }
      }
      depth = next_depth;
      begin = end;
    }
    hn::StoreU(depth, d, depths + i);
    if (running) continue;
    for (std::size_t c = 0; c < 3 && optics.emission[c]; ++c) {
      hn::StoreU(emitted[c], d, optics.emission[c] + i);
    }
    for (std::size_t l = 0; l < lights.size(); ++l) {
      hn::StoreU(mul_add(isotropic_phase, sum[l], hn::LoadU(d, radiance[l] + i)), d,
                 radiance[l] + i);
    }
  }
}

void SumSlices(const PathBatch& rays, const RaySlices& slices, const float* increments,
               const float* moments, const BatchFog& fog, const SliceScattering& scattering,
               float negligible, std::span<const SliceLight> lights, float* depths,
               const SliceWeights& weights, const SliceOptics& optics,
               const std::array<float*, light_pack>& radiance, SliceSums sums) {
  WithRays(D(), rays, [&]<class Rays>() HWY_ATTR {
    SumSlicesOf<Rays>(rays, slices, increments, moments, fog, scattering, negligible, lights,
                      depths, weights, optics, radiance, sums);
  });
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(LookupDepths);
HWY_EXPORT(SumSlices);

void lookup_depths(const OpticalDepthTable& table, const PathBatch& paths, float* depths) {
  if (table.empty()) {
    std::fill_n(depths, paths.padded_size(), 0.0f);
    return;
  }
  HWY_DYNAMIC_DISPATCH(LookupDepths)(table.view(), paths, depths);
}

void sum_slices(const PathBatch& rays, const RaySlices& slices, const float* increments,
                const float* moments, const BatchFog& fog, const SliceScattering& scattering,
                float negligible, std::span<const SliceLight> lights, float* depths,
                const SliceWeights& weights, const SliceOptics& optics,
                const std::array<float*, light_pack>& radiance, SliceSums sums) {
  HWY_DYNAMIC_DISPATCH(SumSlices)
  (rays, slices, increments, moments, fog, scattering, negligible, lights, depths, weights, optics,
   radiance, sums);
}

}  // namespace brume
#endif
