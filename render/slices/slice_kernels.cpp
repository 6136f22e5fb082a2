#include "render/slices/slice_kernels.h"

#include <algorithm>
#include <cmath>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/slices/slice_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/gaussian-inl.h"
#include "render/slices/slice_falloff-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using Vector = V3<V>;

HWY_INLINE V set(float x) {
  return hn::Set(D(), x);
}

// Position of a direction in a table over a map: the lower of the four cells to interpolate, and
// the fractions.
struct MapPosition {
  hn::Vec<hn::RebindToSigned<D>> cell;  // row by row, border included
  V fx, fy;

  // Of q from a point whose components in a perspective map are `origin`; `distance`: from the
  // light.
  HWY_INLINE MapPosition(const DirectionMap& map, const Vector& q, const glm::vec3& origin,
                         V distance) {
    const D d;
    const hn::RebindToSigned<D> di;
    const V one = set(1.0f);
    V u;
    V v;
    if (map.octahedral) {
      const V sum = hn::Add(hn::Abs(q.x), hn::Add(hn::Abs(q.y), hn::Abs(q.z)));
      const V inverse = hn::Div(one, hn::Max(sum, set(coefficient::tiny)));
      const V x = hn::Mul(q.x, inverse);
      const V y = hn::Mul(q.y, inverse);
      const auto below = hn::Lt(q.z, hn::Zero(d));
      u = hn::IfThenElse(below, hn::CopySign(hn::Sub(one, hn::Abs(y)), x), x);
      v = hn::IfThenElse(below, hn::CopySign(hn::Sub(one, hn::Abs(x)), y), y);
    } else {
      const auto along = [&](const glm::vec3& axis, float start) HWY_ATTR {
        return hn::Add(dot(q, Vector{set(axis.x), set(axis.y), set(axis.z)}), set(start));
      };
      // Behind the light there is nothing of interest; clamped to the map's border texel.
      const V depth =
          hn::Max(along(map.axis, origin.z), hn::Mul(set(DirectionMap::min_cosine), distance));
      const V inverse = hn::Div(one, hn::Max(depth, set(coefficient::tiny)));
      u = hn::MulAdd(hn::Mul(along(map.right, origin.x), inverse), set(map.scale.x),
                     set(map.offset.x));
      v = hn::MulAdd(hn::Mul(along(map.up, origin.y), inverse), set(map.scale.y),
                     set(map.offset.y));
    }
    // In cells, counted from the middle of the border cell.
    const auto in_cells = [&](V along, int count) HWY_ATTR {
      const auto cells = static_cast<float>(count);
      const V x = hn::MulAdd(along, set(0.5f * cells), set(0.5f * cells + 0.5f));
      return hn::Min(hn::Max(x, hn::Zero(d)), set(cells + DirectionMap::border_share));
    };
    const V x = in_cells(u, map.columns);
    const V y = in_cells(v, map.rows);
    const auto xi = hn::ConvertTo(di, x);
    const auto yi = hn::ConvertTo(di, y);
    fx = hn::Sub(x, hn::ConvertTo(d, xi));
    fy = hn::Sub(y, hn::ConvertTo(d, yi));
    cell = hn::Add(hn::Mul(yi, hn::Set(di, map.stride())), xi);
  }

  // The mix of value(cell offset) over the four cells.
  template <class Value>
  HWY_INLINE V Mix(int stride, Value value) const {
    const auto mix = [](V low, V high, V f)
                         HWY_ATTR { return hn::MulAdd(f, hn::Sub(high, low), low); };
    return mix(mix(value(0), value(1), fx), mix(value(stride), value(stride + 1), fx), fy);
  }
};

// The depth of a table at q from `origin`, see MapPosition.
HWY_INLINE V Lookup(const OpticalDepthTable::View& table, const Vector& q, const glm::vec3& origin,
                    V distance) {
  const D d;
  const hn::RebindToSigned<D> di;
  const MapPosition position(table.map, q, origin, distance);
  const V beyond = hn::Max(hn::Sub(distance, set(table.first_radius)), hn::Zero(d));
  V r = hn::Mul(beyond, set(table.radii_per_unit));
  if (table.curvature > 0.0f) r = hn::Div(r, hn::MulAdd(set(table.curvature), beyond, set(1.0f)));
  r = hn::Min(r, set(static_cast<float>(table.radii) - coefficient::table_end));
  const auto ri = hn::ConvertTo(di, r);
  const V fr = hn::Sub(r, hn::ConvertTo(d, ri));
  const auto first = hn::Add(hn::Mul(position.cell, hn::Set(di, table.radii)), ri);
  // Two neighbours of 16 bits come in one gather.
  const auto* pairs = reinterpret_cast<const std::int32_t*>(table.depths);
  const V depth = position.Mix(table.map.stride(), [&](int cell) HWY_ATTR {
    const auto index = hn::Add(first, hn::Set(di, cell * table.radii));
    const auto both = hn::GatherOffset(di, pairs, hn::ShiftLeft<1>(index));
    const V near = hn::ConvertTo(d, hn::And(both, hn::Set(di, 0xffff)));
    const V far = hn::ConvertTo(
        d, hn::BitCast(di, hn::ShiftRight<16>(hn::BitCast(hn::RebindToUnsigned<D>(), both))));
    return hn::MulAdd(fr, hn::Sub(far, near), near);
  });
  return hn::Mul(depth, set(table.unit));
}

void LookupDepths(const OpticalDepthTable::View& table, const PathBatch& paths, float* depths) {
  const D d;
  for (std::size_t i = 0; i < paths.padded_size(); i += hn::Lanes(d)) {
    const V distance = hn::LoadU(d, paths.length.data() + i);
    const Vector q{hn::Mul(distance, hn::LoadU(d, paths.x.data() + i)),
                   hn::Mul(distance, hn::LoadU(d, paths.y.data() + i)),
                   hn::Mul(distance, hn::LoadU(d, paths.z.data() + i))};
    hn::StoreU(Lookup(table, q, glm::vec3(0.0f), distance), d, depths + i);
  }
}

// Visibility, bilinear over four cells (percentage-closer filtering).
HWY_INLINE V Lit(const SliceLight& light, const Vector& q, V distance) {
  const D d;
  const hn::RebindToSigned<D> di;
  const ShadowMap& shadows = *light.shadows;
  const DirectionMap& map = shadows.map();
  const MapPosition position(map, q, light.in_shadows, distance);
  const V depth = map.octahedral
                      ? distance
                      : hn::Add(dot(q, Vector{set(map.axis.x), set(map.axis.y), set(map.axis.z)}),
                                set(light.shadow_depth));
  // Slope bias of the shadow map: avoids self-shadowing.
  const V near = hn::NegMulAdd(distance, set(shadow_bias(map)), depth);
  // Mostly all four cells agree.
  const float* const ranges = &shadows.ranges()->min_depth;
  const auto range = hn::ShiftLeft<1>(position.cell);
  const auto lit = hn::Le(near, hn::GatherIndex(d, ranges, range));
  if (hn::AllTrue(d, lit)) return set(1.0f);
  const auto dark = hn::Gt(near, hn::GatherIndex(d, ranges, hn::Add(range, hn::Set(di, 1))));
  if (hn::AllTrue(d, hn::Or(lit, dark))) return hn::IfThenElseZero(lit, set(1.0f));
  return position.Mix(shadows.map().stride(), [&](int cell) HWY_ATTR {
    const V occluder_depth =
        hn::GatherIndex(d, shadows.depths(), hn::Add(position.cell, hn::Set(di, cell)));
    return hn::IfThenElseZero(hn::Le(near, occluder_depth), set(1.0f));
  });
}

// SliceWeights::along_rays: where the Gaussians have the depth G(t) on the ray, the integral of
// (G' + b0) exp(-(1 -+ e) G - b0 t) dt, + for light from the eye, e its extinction. The exponent
// grows evenly within a slice.
void SumAlongRays(const RaySlices& slices, std::size_t stride, const float* increments,
                  bool has_optics, float b0, float exponent_per_depth, bool running, float* sums) {
  const D d;
  // Of the first optics: the albedo.
  const std::size_t to_scattered = has_optics ? (slices.count() - 1) * stride : 0;
  const V per_depth = set(exponent_per_depth);
  for (std::size_t i = 0; i < stride; i += hn::Lanes(d)) {
    V begin = hn::LoadU(d, slices.at(i, 0));
    V transmittance_in = hn::Exp(d, hn::Mul(set(-b0), begin));
    V sum = hn::Zero(d);
    for (std::size_t k = 0; k + 1 < slices.count(); ++k) {
      const V end = hn::LoadU(d, slices.at(i, k + 1));
      const V fog = hn::Mul(set(b0), hn::Sub(end, begin));
      const V gaussians = hn::Max(hn::LoadU(d, increments + k * stride + i), hn::Zero(d));
      const V exponent = hn::MulAdd(per_depth, gaussians, fog);
      const V transmittance_out = hn::Mul(transmittance_in, hn::Exp(d, hn::Neg(exponent)));
      // The mean of exp(-exponent x) over x in [0, 1], times what passes.
      const V mean = hn::IfThenElse(
          hn::Lt(exponent, set(coefficient::small_exponent)),
          hn::NegMulAdd(hn::Mul(set(0.5f), exponent), transmittance_in, transmittance_in),
          hn::Div(hn::Sub(transmittance_in, transmittance_out),
                  hn::Max(exponent, set(coefficient::tiny))));
      const V scattered =
          hn::Max(hn::LoadU(d, increments + to_scattered + k * stride + i), hn::Zero(d));
      sum = hn::MulAdd(mean, hn::Add(scattered, fog), sum);
      if (running) hn::StoreU(sum, d, sums + k * stride + i);
      transmittance_in = transmittance_out;
      begin = end;
    }
    if (!running) hn::StoreU(sum, d, sums + i);
  }
}

// exp(-T) (1 - exp(-dT)), without cancellation for small dT.
HWY_INLINE V ScatteredFraction(V depth, V increment) {
  const D d;
  return hn::Mul(hn::Exp(d, hn::Neg(depth)),
                 hn::IfThenElse(hn::Lt(increment, set(coefficient::small_increment)),
                                hn::NegMulAdd(hn::Mul(set(0.5f), increment), increment, increment),
                                hn::Sub(set(1.0f), hn::Exp(d, hn::Neg(increment)))));
}

// FogBall::length() from a point on a ray.
HWY_INLINE V FogLength(const SliceLight& light, V t, const Vector& w, V distance) {
  const D d;
  const Vector q{hn::MulSub(t, w.x, set(light.position.x)),
                 hn::MulSub(t, w.y, set(light.position.y)),
                 hn::MulSub(t, w.z, set(light.position.z))};
  const Vector p{hn::MulSub(t, w.x, set(light.fog_center.x)),
                 hn::MulSub(t, w.y, set(light.fog_center.y)),
                 hn::MulSub(t, w.z, set(light.fog_center.z))};
  const V along = hn::Neg(hn::Div(dot(p, q), distance));
  const V square =
      hn::Add(hn::MulSub(along, along, dot(p, p)), set(light.fog_radius * light.fog_radius));
  const V half = hn::Sqrt(hn::Max(square, hn::Zero(d)));
  return hn::Min(hn::Max(hn::Sub(half, along), hn::Zero(d)), hn::Add(half, half));
}

HWY_INLINE V TruncatedPhase(const SliceScattering& scattering, V cosine) {
  const auto& power = scattering.truncated_phase;
  V sum = set(power[3]);
  for (std::size_t i = 3; i-- > 0;) sum = hn::MulAdd(sum, cosine, set(power[i]));
  return sum;
}

// What a LobeBroadening's table holds, bilinear.
HWY_INLINE V LobeLoss(const float* table, V cosine, V depth) {
  const D d;
  const hn::RebindToSigned<D> di;
  constexpr auto angles = static_cast<float>(LobeBroadening::angles);
  constexpr auto depths = static_cast<float>(LobeBroadening::depths);
  const V half_sine_2 = hn::NegMulAdd(set(0.5f), cosine, set(0.5f));
  const V angle = hn::Mul(set(angles - 1.0f), hn::Sqrt(hn::Max(half_sine_2, hn::Zero(d))));
  const V share = hn::Div(depth, hn::Add(depth, set(LobeBroadening::depth_scale)));
  const V x = hn::Min(angle, set(angles - coefficient::table_end));
  const V y = hn::Min(hn::Mul(share, set(depths)), set(depths - coefficient::table_end));
  const auto xi = hn::ConvertTo(di, x);
  const auto yi = hn::ConvertTo(di, y);
  const V fx = hn::Sub(x, hn::ConvertTo(d, xi));
  const V fy = hn::Sub(y, hn::ConvertTo(d, yi));
  const auto first = hn::Add(hn::Mul(xi, hn::Set(di, LobeBroadening::depths)), yi);
  const auto at_angle = [&](int offset) HWY_ATTR {
    const auto index = hn::Add(first, hn::Set(di, offset));
    const V low = hn::GatherIndex(d, table, index);
    const V high = hn::GatherIndex(d, table, hn::Add(index, hn::Set(di, 1)));
    return hn::MulAdd(fy, hn::Sub(high, low), low);
  };
  const V narrow = at_angle(0);
  return hn::MulAdd(fx, hn::Sub(at_angle(LobeBroadening::depths), narrow), narrow);
}

void SumSlices(const PathBatch& rays, const RaySlices& slices, const float* increments,
               const float* moments, float b0, const SliceScattering& scattering, float negligible,
               std::span<const SliceLight> lights, float* depths, const SliceWeights& weights,
               const SliceOptics& optics, const std::array<float*, light_pack>& radiance,
               SliceSums sums) {
  constexpr float isotropic_phase = 0.0795774715459476679f;  // 1 / (4 pi)
  const D d;
  const bool running = sums == SliceSums::running;
  const V zero = hn::Zero(d);
  const std::size_t stride = rays.padded_size();
  const std::size_t plane = (slices.count() - 1) * stride;
  if (weights.along_rays) {
    const float from_eye = scattering.anisotropy < 0.0f ? 1.0f : -1.0f;
    SumAlongRays(slices, stride, increments, optics.has, b0, 1.0f + from_eye * weights.extinction,
                 running, weights.along_rays);
  }
  const bool has_view_extinction = scattering.view_extinction != 1.0f;
  const V view_extinction = set(scattering.view_extinction);
  std::array<OpticalDepthTable::View, light_pack> tables{};
  for (std::size_t l = 0; l < lights.size(); ++l) {
    if (lights[l].table && !lights[l].table->empty()) tables[l] = lights[l].table->view();
  }
  for (std::size_t i = 0; i < stride; i += hn::Lanes(d)) {
    const Vector w{hn::LoadU(d, rays.x.data() + i), hn::LoadU(d, rays.y.data() + i),
                   hn::LoadU(d, rays.z.data() + i)};
    V ts[light_pack];
    V h2[light_pack];
    V sum[light_pack];
    FalloffRays falloffs[light_pack];
    for (std::size_t l = 0; l < lights.size(); ++l) {
      const Vector s{set(lights[l].position.x), set(lights[l].position.y),
                     set(lights[l].position.z)};
      ts[l] = dot(s, w);
      const Vector offset = minus(s, ts[l], w);
      h2[l] = hn::Max(dot(offset, offset),
                      set(std::max(lights[l].h_min * lights[l].h_min, coefficient::tiny)));
      sum[l] = zero;
      if (!lights[l].falloff.is_isotropic())
        falloffs[l] = FalloffRays(lights[l].falloff, w, offset, h2[l]);
    }
    V depth = zero;
    V begin = hn::LoadU(d, slices.at(i, 0));
    V emitted[3] = {zero, zero, zero};
    V weight = zero;  // of a look-up
    V weighted_distance = zero;
    for (std::size_t k = 0; k + 1 < slices.count(); ++k) {
      const V end = hn::LoadU(d, slices.at(i, k + 1));
      const V width = hn::Sub(end, begin);
      const V gaussians = hn::Max(hn::LoadU(d, increments + k * stride + i), zero);
      const V increment = hn::MulAdd(set(b0), width, gaussians);
      const V next_depth = hn::Add(depth, increment);
      const auto matters =
          hn::And(hn::Gt(increment, set(negligible)),
                  hn::Lt(hn::Mul(view_extinction, depth), set(coefficient::visible_depth)));
      if (!hn::AllFalse(d, matters)) {
        V scattered_fraction = ScatteredFraction(depth, increment);
        V truncated_fraction = has_view_extinction
                                   ? hn::Div(ScatteredFraction(hn::Mul(view_extinction, depth),
                                                               hn::Mul(view_extinction, increment)),
                                             view_extinction)
                                   : scattered_fraction;
        if (optics.has) {
          const float* const own = increments + plane + k * stride + i;
          const V inverse = hn::Div(set(1.0f), hn::Max(increment, set(coefficient::tiny)));
          const V emitting = hn::IfThenElseZero(matters, hn::Mul(scattered_fraction, inverse));
          for (std::size_t c = 0; c < 3 && optics.emission[c]; ++c) {
            const V emission = hn::Max(hn::LoadU(d, own + (c + 1) * plane), zero);
            emitted[c] = hn::MulAdd(emitting, emission, emitted[c]);
          }
          const V scattering_depth = hn::MulAdd(set(b0), width, hn::Max(hn::LoadU(d, own), zero));
          const V albedo = hn::Mul(scattering_depth, inverse);
          scattered_fraction = hn::Mul(scattered_fraction, albedo);
          truncated_fraction = hn::Mul(truncated_fraction, albedo);
        }
        // Of what the slice holds, fog evenly.
        const V middle_of_slice = hn::Mul(set(0.5f), hn::Add(begin, end));
        const V fog_moment = hn::Mul(hn::Mul(set(b0), width), middle_of_slice);
        const V moment = hn::Add(fog_moment, hn::LoadU(d, moments + k * stride + i));
        const V mean = hn::Div(moment, hn::Max(increment, set(coefficient::tiny)));
        const V held = hn::Min(hn::Max(mean, begin), end);
        // Lit over the part around it that lies within the slice, up to the variance of a linear
        // density of this mean, or of one that falls to zero.
        const V half = hn::Mul(set(0.5f), width);
        const V off = hn::Abs(hn::Sub(held, middle_of_slice));
        const V square = hn::NegMulAdd(hn::Mul(set(3.0f), off), off, hn::Mul(half, half));
        const V linear = hn::Sqrt(hn::Max(square, zero));
        const V falling = hn::Mul(set(coefficient::falling_reach), hn::Sub(half, off));
        const V reach = hn::IfThenElse(hn::Lt(hn::Mul(set(3.0f), off), half), linear, falling);
        // What is in front counts for more.
        const V front = hn::Min(increment, set(coefficient::max_front_depth));
        const V shift =
            hn::Div(hn::Mul(reach, front), hn::Add(front, set(coefficient::front_depth)));
        const V center = hn::Max(hn::Sub(held, shift), begin);
        const V lit = hn::Max(hn::Min(reach, hn::Min(hn::Sub(center, begin), hn::Sub(end, center))),
                              hn::Mul(set(coefficient::min_lit_share), width));
        const V counted = hn::IfThenElseZero(matters, truncated_fraction);
        weight = hn::Add(weight, counted);
        weighted_distance = hn::MulAdd(counted, center, weighted_distance);
        for (std::size_t l = 0; l < lights.size(); ++l) {
          const V first = hn::Sub(hn::Sub(center, lit), ts[l]);
          const V last = hn::Sub(hn::Add(center, lit), ts[l]);
          V falloff;
          V middle = center;
          if (lights[l].falloff.is_isotropic()) {
            falloff = MeanInverseSquare(first, last, h2[l]);
          } else {
            const FalloffMean segment(falloffs[l], first, last, h2[l]);
            if (hn::AllFalse(d, hn::Gt(segment.value, zero))) continue;
            falloff = segment.value;
            middle = hn::Add(ts[l], segment.center);
          }
          const V along = hn::Sub(middle, ts[l]);
          const V distance = hn::Sqrt(hn::MulAdd(along, along, h2[l]));
          const Vector q{hn::MulSub(middle, w.x, set(lights[l].map_origin.x)),
                         hn::MulSub(middle, w.y, set(lights[l].map_origin.y)),
                         hn::MulSub(middle, w.z, set(lights[l].map_origin.z))};
          V light_depth = hn::Mul(set(b0), lights[l].fog_radius > 0.0f
                                               ? FogLength(lights[l], middle, w, distance)
                                               : distance);
          if (tables[l].depths) {
            light_depth = hn::Add(light_depth, Lookup(tables[l], q, lights[l].in_table, distance));
          }
          V light = hn::Mul(falloff, hn::Exp(d, hn::Mul(light_depth, set(-lights[l].extinction))));
          if (lights[l].shadows) light = hn::Mul(light, Lit(lights[l], q, distance));
          V fraction = scattered_fraction;
          if (scattering.anisotropy != 0.0f) {
            const V cosine = CosTheta(d, along, distance);
            V phase = HenyeyGreenstein(d, cosine, scattering.anisotropy);
            if (scattering.lobe_broadening) {
              const V path = hn::MulAdd(set(0.5f), increment, hn::Add(depth, light_depth));
              phase = hn::Sub(phase, LobeLoss(scattering.lobe_broadening, cosine,
                                              hn::Mul(set(scattering.albedo), path)));
            }
            fraction = hn::Mul(fraction, phase);
            if (has_view_extinction) {
              const V more = hn::Sub(truncated_fraction, scattered_fraction);
              fraction = hn::MulAdd(more, TruncatedPhase(scattering, cosine), fraction);
            }
          }
          sum[l] = hn::Add(sum[l], hn::IfThenElseZero(matters, hn::Mul(fraction, light)));
        }
      }
      if (weights.lookups && ((k + 1) % slices_per_lookup == 0 || k + 2 == slices.count())) {
        const std::size_t at = k / slices_per_lookup * stride + i;
        hn::StoreU(weight, d, weights.lookups + at);
        hn::StoreU(hn::Div(weighted_distance, hn::Max(weight, set(coefficient::tiny))), d,
                   weights.lookup_distances + at);
        weight = zero;
        weighted_distance = zero;
      }
      if (running) {
        const std::size_t at = k * stride + i;
        for (std::size_t c = 0; c < 3 && optics.emission[c]; ++c) {
          hn::StoreU(emitted[c], d, optics.emission[c] + at);
        }
        for (std::size_t l = 0; l < lights.size(); ++l) {
          hn::StoreU(hn::Mul(set(isotropic_phase), sum[l]), d, radiance[l] + at);
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
      hn::StoreU(hn::MulAdd(set(isotropic_phase), sum[l], hn::LoadU(d, radiance[l] + i)), d,
                 radiance[l] + i);
    }
  }
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
                const float* moments, float b0, const SliceScattering& scattering, float negligible,
                std::span<const SliceLight> lights, float* depths, const SliceWeights& weights,
                const SliceOptics& optics, const std::array<float*, light_pack>& radiance,
                SliceSums sums) {
  HWY_DYNAMIC_DISPATCH(SumSlices)
  (rays, slices, increments, moments, b0, scattering, negligible, lights, depths, weights, optics,
   radiance, sums);
}

}  // namespace brume
#endif
