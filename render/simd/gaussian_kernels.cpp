#include "render/simd/gaussian_kernels.h"

#include <hwy/cache_control.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/math/max_component.h"
#include "render/geometry/ray_range.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/simd/gaussian_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/gaussian-inl.h"
#include "render/simd/noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
using Vector = V3<V>;

HWY_INLINE V set(float x) {
  return hn::Set(D(), x);
}

template <BatchKind kKind, class Rays>
HWY_INLINE void PathDepths(const GaussianBatch& g, const PathBatch& paths, float* depths) {
  const D d;
  const hn::RebindToSigned<D> di;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t k = 0; k < paths.padded_size(); k += lanes) {
    const Rays rays(d, paths, k);
    const V length = hn::LoadU(d, paths.length.data() + k);
    const auto self = hn::LoadU(di, paths.self.data() + k);
    V sum = hn::LoadU(d, depths + k);
    for (std::size_t j = 0; j < g.size(); ++j) {
      const LineProfile<V> line = BatchLineProfile<kKind>(d, g, j, rays);
      // Whatever paths share a vector.
      const M reached = line.e <= g.max_e[j];
      if (hn::AllFalse(d, reached)) continue;
      const V half_depth = where(reached, BatchHalfDepth<kKind>(d, g, j, line));
      const V depth = half_depth * unit_depth(line, length);
      const auto is_self = hn::RebindMask(d, hn::Eq(self, hn::Set(di, g.index[j])));
      sum += hn::IfThenZeroElse(is_self, depth);
    }
    hn::StoreU(sum, d, depths + k);
  }
}

void AccumulatePathDepths(const GaussianBatch& g, const PathBatch& paths, float* depths) {
  WithRays(D(), paths, [&]<class Rays>() HWY_ATTR {
    with_kind(g, [&]<BatchKind kKind>() HWY_ATTR { PathDepths<kKind, Rays>(g, paths, depths); });
  });
}

// The depth of Gaussian j from points at t on rays to a light.
template <BatchKind kKind, class Rays>
class LightDepth {
 public:
  HWY_INLINE LightDepth(const GaussianBatch& g, std::size_t j, const Rays& rays, V t)
      : g_(g),
        j_(j),
        rays_(rays),
        t_(t),
        center_(rays.From({set(g.x[j]), set(g.y[j]), set(g.z[j])})),
        direction_(rays.w) {
    if constexpr (kKind == BatchKind::ellipsoids) {
      if (!g.is_ellipsoid(j)) return;
      const glm::vec3& center = g.ellipsoids[j].center;
      const WarpOf<V> warp = BatchWarp(D(), g.ellipsoids[j]);
      center_ = rays.From(warp, {set(center.x), set(center.y), set(center.z)});
      direction_ = warp(rays.w);
    }
  }

  // `light`: its place; the inverse of its distance from the points.
  HWY_INLINE V operator()(const glm::vec3& light, V distance, V inverse) const {
    const D d;
    const auto line_to = [&](const Vector& s) HWY_ATTR {
      const Vector q = neg_mul_add(t_, direction_, s);
      return Vector{q.x * inverse, q.y * inverse, q.z * inverse};
    };
    const Vector from_point = neg_mul_add(t_, direction_, center_);
    const V a = set(g_.a[j_]);
    if constexpr (kKind == BatchKind::ellipsoids) {
      if (g_.is_ellipsoid(j_)) {
        const auto& [xx, yy, zz, yz, xz, xy] = g_.ellipsoids[j_].warp;
        const glm::vec3 warped(xx * light.x + xy * light.y + xz * light.z,
                               xy * light.x + yy * light.y + yz * light.z,
                               xz * light.x + yz * light.y + zz * light.z);
        const Vector s = rays_.From(BatchWarp(d, g_.ellipsoids[j_]),
                                    {set(warped.x), set(warped.y), set(warped.z)});
        const LineProfile<V> line = warped_line_profile(from_point, line_to(s), a);
        return BatchHalfDepth<kKind>(d, g_, j_, line) * unit_depth(line, distance);
      }
    }
    const Vector s = rays_.From({set(light.x), set(light.y), set(light.z)});
    const LineProfile<V> line = line_profile(from_point, line_to(s), a);
    return g_.scale[j_] * unit_depth(line, distance);
  }

 private:
  const GaussianBatch& g_;
  std::size_t j_;
  const Rays& rays_;
  V t_;
  Vector center_, direction_;  // of an ellipsoid as warped
};

// One pack of `kLights` lights; the number is a constant so that sums stay in registers.
template <BatchKind kKind, class Rays, std::size_t kLights>
HWY_INLINE std::uint64_t PaperAirlight(const GaussianBatch& g, const PathBatch& paths,
                                       const LightBatch& lights, float* depths, float* scattered,
                                       const std::array<float*, light_pack>& radiance) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  const V zero = hn::Zero(d);
  std::uint64_t pairs = 0;
  for (std::size_t k = 0; k < paths.padded_size(); k += lanes) {
    const Rays rays(d, paths, k);
    const Vector& w = rays.w;
    const V length = hn::LoadU(d, paths.length.data() + k);
    V ts[kLights > 0 ? kLights : 1];
    V offset2[kLights > 0 ? kLights : 1];
    V sum[kLights > 0 ? kLights : 1];
    for (std::size_t l = 0; l < kLights; ++l) {
      const Vector s = rays.From({set(lights.x[l]), set(lights.y[l]), set(lights.z[l])});
      ts[l] = dot(s, w);
      const Vector offset = neg_mul_add(ts[l], w, s);
      offset2[l] = dot(offset, offset);
      sum[l] = zero;
    }
    V depth_sum = zero;
    V scattered_sum = zero;
    for (std::size_t j = 0; j < g.size(); ++j) {
      const LineProfile<V> line = BatchLineProfile<kKind>(d, g, j, rays);
      const M reached = line.e <= g.max_e[j];
      if (hn::AllFalse(d, reached)) continue;
      pairs += hn::CountTrue(d, reached);
      const V scale = where(reached, BatchHalfDepth<kKind>(d, g, j, line));
      const V per_scale = unit_depth(line, length);
      const V depth = scale * per_scale;
      depth_sum += depth;

      V t;
      V depth_to_point;
      if (lights.at_mean) {
        t = mean_parameter(line, length, per_scale);
        depth_to_point = scale * unit_depth(line, t);
      } else {
        t = clamp(line.t0, zero, length);
        depth_to_point = scale * depth_to_projection(line, length, per_scale);
      }
      if (scattered) {
        const V exponent = lights.from_eye[j] + depth_to_point;
        scattered_sum = mul_add(depth, exp(-exponent), scattered_sum);
      }
      const LightDepth<kKind, Rays> light_depth_of(g, j, rays, t);
      for (std::size_t l = 0; l < kLights; ++l) {
        const V along = t - ts[l];
        // Attenuation uses the true length; only 1/r^2 is clamped (PointLightRay).
        const V h2 = max(offset2[l], lights.h_min[l] * lights.h_min[l]);
        const V distance2 = mul_add(along, along, h2);
        const V distance = sqrt(max(mul_add(along, along, offset2[l]), tiny));
        const V inverse = 1.0f / distance;
        const V light_depth =
            light_depth_of({lights.x[l], lights.y[l], lights.z[l]}, distance, inverse);
        const V exponent = lights.frozen[l][j] + (depth_to_point + light_depth);
        const V falloff = exp(-exponent) / distance2;
        V towards_eye = depth;
        if (lights.anisotropy != 0.0f) {
          towards_eye = depth * henyey_greenstein(cos_theta(along, distance), lights.anisotropy);
        }
        sum[l] = mul_add(towards_eye, falloff, sum[l]);
      }
    }
    if (scattered) {
      hn::StoreU(scattered_sum + hn::LoadU(d, scattered + k), d, scattered + k);
    }
    if (depths) hn::StoreU(depth_sum + hn::LoadU(d, depths + k), d, depths + k);
    for (std::size_t l = 0; l < kLights; ++l) {
      const V old = hn::LoadU(d, radiance[l] + k);
      hn::StoreU(mul_add(isotropic_phase, sum[l], old), d, radiance[l] + k);
    }
  }
  return pairs;
}

template <BatchKind kKind, class Rays>
HWY_INLINE std::uint64_t PaperAirlightOfPack(const GaussianBatch& g, const PathBatch& rays,
                                             const LightBatch& lights, float* depths,
                                             float* scattered,
                                             const std::array<float*, light_pack>& radiance) {
  switch (lights.count) {
    case 0:
      return PaperAirlight<kKind, Rays, 0>(g, rays, lights, depths, scattered, radiance);
    case 1:
      return PaperAirlight<kKind, Rays, 1>(g, rays, lights, depths, scattered, radiance);
    case 2:
      return PaperAirlight<kKind, Rays, 2>(g, rays, lights, depths, scattered, radiance);
    case 3:
      return PaperAirlight<kKind, Rays, 3>(g, rays, lights, depths, scattered, radiance);
    default:
      return PaperAirlight<kKind, Rays, 4>(g, rays, lights, depths, scattered, radiance);
  }
}

std::uint64_t AccumulatePaperAirlight(const GaussianBatch& g, const PathBatch& rays,
                                      const LightBatch& lights, float* depths, float* scattered,
                                      const std::array<float*, light_pack>& radiance) {
  return WithRays(D(), rays, [&]<class Rays>() HWY_ATTR {
    return with_kind(g, [&]<BatchKind kKind>() HWY_ATTR {
      return PaperAirlightOfPack<kKind, Rays>(g, rays, lights, depths, scattered, radiance);
    });
  });
}

template <class Rays>
HWY_INLINE void HomogeneousAirlight(const BatchFog& fog, float attenuation, const glm::vec3& light,
                                    float h_min, float anisotropy, const PathBatch& paths,
                                    float* radiance) {
  const D d;
  const V zero = hn::Zero(d);
  // Width [radians] of the first panel, at the peak.
  const float first_panel = fog_panel * (1.0f - std::abs(anisotropy));
  const int panels = 1 + std::max(0, static_cast<int>(std::ceil(std::log2(pi / first_panel))));
  for (std::size_t k = 0; k < paths.padded_size(); k += hn::Lanes(d)) {
    const Rays rays(d, paths, k);
    const Vector& w = rays.w;
    const Vector s = rays.From({set(light.x), set(light.y), set(light.z)});
    const FogInterval<V> in_fog = FogOnRays(rays, fog);
    const Vector start = FromPosition(rays, in_fog.begin, fog.center);
    const V length = fog_overlap(in_fog, zero, hn::LoadU(d, paths.length.data() + k));
    const FogRay<V> ray =
        fog_ray(neg_mul_add(in_fog.begin, w, s), w, length, h_min, fog.density, start, fog.radius);
    // A forward peak of the phase function lies at angle 0 between light and view, a backward one
    // at pi: panels double from there.
    const V phi_offset = anisotropy < 0.0f ? pi - (ray.at_start + ray.span) : ray.at_start;
    V mean = zero;
    for (int panel = 0; panel < panels; ++panel) {
      const auto panel_end = [&](int count) HWY_ATTR {
        const V angle = count == panels ? set(fog_panel) : set(std::ldexp(first_panel, count - 1));
        return clamp(angle - phi_offset, 0.0, ray.span);
      };
      const V panel_begin = panel == 0 ? zero : panel_end(panel);
      const V panel_width = panel_end(panel + 1) - panel_begin;
      if (hn::AllTrue(d, panel_width <= zero)) continue;
      V sum = zero;
      for (int i = 0; i < 8; ++i) {
        const V angle = mul_add(panel_width, fog_rule.nodes[i], panel_begin);
        const V phi = anisotropy < 0.0f ? ray.span - angle : angle;
        sum = mul_add(fog_rule.weights[i], fog_light(ray, phi, fog.density, anisotropy), sum);
      }
      mean = mul_add(sum, panel_width / ray.h, mean);
    }
    const V gain = set(fog.density * attenuation * static_cast<float>(isotropic_phase));
    hn::StoreU(mul_add(gain, mean, hn::LoadU(d, radiance + k)), d, radiance + k);
  }
}

void AccumulateHomogeneousAirlight(const BatchFog& fog, float attenuation, const glm::vec3& light,
                                   float h_min, float anisotropy, const PathBatch& rays,
                                   float* radiance) {
  WithRays(D(), rays, [&]<class Rays>() HWY_ATTR {
    HomogeneousAirlight<Rays>(fog, attenuation, light, h_min, anisotropy, rays, radiance);
  });
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

BatchFog::BatchFog(const MediumIndex& medium, const glm::dvec3& origin)
    : density(static_cast<float>(medium.homogeneous_density())) {
  if (medium.fog().is_endless()) return;
  center = glm::vec3(medium.fog().center - origin);
  radius = static_cast<float>(medium.fog().radius);
}

HWY_EXPORT(AccumulatePathDepths);
HWY_EXPORT(AccumulatePaperAirlight);
HWY_EXPORT(AccumulateHomogeneousAirlight);

void accumulate_path_depths(const GaussianBatch& gaussians, const PathBatch& paths, float* depths) {
  HWY_DYNAMIC_DISPATCH(AccumulatePathDepths)(gaussians, paths, depths);
}

std::uint64_t accumulate_paper_airlight(const GaussianBatch& gaussians, const PathBatch& rays,
                                        const LightBatch& lights, float* depths, float* scattered,
                                        const std::array<float*, light_pack>& radiance) {
  return HWY_DYNAMIC_DISPATCH(AccumulatePaperAirlight)(gaussians, rays, lights, depths, scattered,
                                                       radiance);
}

void accumulate_homogeneous_airlight(const BatchFog& fog, float attenuation, const glm::vec3& light,
                                     float h_min, float anisotropy, const PathBatch& rays,
                                     float* radiance) {
  HWY_DYNAMIC_DISPATCH(AccumulateHomogeneousAirlight)
  (fog, attenuation, light, h_min, anisotropy, rays, radiance);
}

// A large medium is not in the cache, and a tile's Gaussians are all over it.
constexpr std::size_t ahead = 16;

void GaussianBatch::assign(const MediumIndex& medium, const glm::dvec3& origin,
                           std::span<const std::uint32_t> indices, const RayNoise& ray_noise,
                           const std::optional<glm::dvec3>& direction) {
  for (auto* array : {&x, &y, &z, &a, &scale, &max_e, &near, &far, &reach}) {
    array->resize(padded(indices.size()));
  }
  index.resize(indices.size());
  ellipsoids.clear();
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (k + ahead < indices.size()) {
      const std::uint32_t later = indices[k + ahead];
      hwy::Prefetch(&medium.gaussians()[later]);
      hwy::Prefetch(&medium.cutoff_radii()[later]);
    }
    const GaussianTerm<double>& g = medium.gaussians()[indices[k]];
    const glm::vec3 b(g.b - origin);
    const double cutoff_in_radii = medium.cutoff_radii()[indices[k]] * g.a;
    x[k] = b.x;
    y[k] = b.y;
    z[k] = b.z;
    a[k] = static_cast<float>(g.a);
    // Clamped: already opaque, and keeps float sums finite.
    scale[k] = static_cast<float>(std::min(g.c / g.a * (0.5 * coefficient::sqrt_pi), 1e20));
    max_e[k] = static_cast<float>(cutoff_in_radii * cutoff_in_radii);
    index[k] = static_cast<std::int32_t>(indices[k]);
    const auto radius = static_cast<float>(medium.view_cutoff_radius(indices[k]));
    reach[k] = radius;
    if (direction) {
      const auto nearest = static_cast<float>(glm::dot(g.b - origin, *direction));
      near[k] = nearest - radius;
      far[k] = nearest + radius;
    } else {
      // A ray that passes the center at h is nearest to it at sqrt(distance^2 - h^2).
      const float distance2 = glm::dot(b, b);
      near[k] = std::sqrt(std::max(distance2 - radius * radius, 0.0f)) - radius;
      far[k] = std::sqrt(distance2) + radius;
    }
    if (g.ellipsoid) add_ellipsoid(k, g, origin, direction);
  }
  for (auto& values : optics) values.clear();
  max_undisplaced_e.clear();
  noise = {};
  if (!ray_noise.on()) return;
  for (const float e : std::span(max_e).first(size())) {
    const auto max_displacement = static_cast<float>(RayNoise::max_shift * ray_noise.amplitude());
    max_undisplaced_e.push_back((std::sqrt(e) + max_displacement) *
                                (std::sqrt(e) + max_displacement));
  }
  const glm::vec3 cell(ray_noise.cell(origin));
  noise = {static_cast<float>(ray_noise.amplitude() / noise_lattice::rms),
           static_cast<float>(std::min(ray_noise.frequency(), endless)),
           cell.x,
           cell.y,
           cell.z,
           ray_noise.key()};
}

void GaussianBatch::assign(const MediumIndex& medium, const TileRays& rays,
                           std::span<const std::uint32_t> indices) {
  const bool is_parallel = !rays.offsets.empty();
  assign(medium, rays.eye, indices, medium.noise(),
         is_parallel ? std::optional(rays.directions.front()) : std::nullopt);
}

void GaussianBatch::add_ellipsoid(std::size_t k, const GaussianTerm<double>& g,
                                  const glm::dvec3& origin,
                                  const std::optional<glm::dvec3>& direction) {
  if (ellipsoids.empty()) ellipsoids.resize(size());
  const glm::mat3 warp(g.ellipsoid->warp);
  const glm::dvec3 q = g.b - origin;
  ellipsoids[k].warp = {warp[0][0], warp[1][1], warp[2][2], warp[1][2], warp[0][2], warp[0][1]};
  ellipsoids[k].center = glm::vec3(g.ellipsoid->warp * q);
  ellipsoids[k].max_speed = static_cast<float>(1.0 / min_component(g.ellipsoid->stretch));
  if (direction) {
    const auto nearest = glm::dot(q, *direction);
    const double along = static_cast<double>(reach[k]) * g.ellipsoid->reach(*direction);
    near[k] = std::max(near[k], static_cast<float>(nearest - along));
    far[k] = std::min(far[k], static_cast<float>(nearest + along));
    return;
  }
  // It lies between two planes across the line to its center.
  const double distance = glm::length(q);
  if (!(distance > 0.0)) return;
  const auto radius = static_cast<double>(reach[k]);
  const double along = radius * g.ellipsoid->reach(q / distance);
  near[k] = std::max(near[k], static_cast<float>(distance - along));
  far[k] = std::min(far[k], static_cast<float>(std::hypot(distance + along, radius)));
}

void GaussianBatch::add_optics(const MediumIndex& medium) {
  const std::span<const RelativeOptics> all = medium.optics();
  if (all.empty()) return;
  for (const std::int32_t i : index) {
    const RelativeOptics& own_optics = all[static_cast<std::size_t>(i)];
    optics[0].push_back(static_cast<float>(own_optics.albedo));
    for (std::size_t c = 0; c < 3; ++c) {
      optics[c + 1].push_back(static_cast<float>(own_optics.emission[static_cast<int>(c)]));
    }
  }
}

void PathBatch::resize(std::size_t size) {
  count = size;
  // Padding rays are valid rays of length 0.
  x.assign(padded(size), 0.0f);
  y.assign(padded(size), 0.0f);
  z.assign(padded(size), 1.0f);
  for (auto* offset : {&offset_x, &offset_y, &offset_z}) offset->clear();
  length.assign(padded(size), 0.0f);
  self.assign(padded(size), -1);
}

void PathBatch::assign(std::span<const glm::dvec3> directions, std::span<const double> lengths) {
  resize(directions.size());
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const glm::vec3 w(directions[k]);
    x[k] = w.x;
    y[k] = w.y;
    z[k] = w.z;
    length[k] = static_cast<float>(lengths[k]);
  }
}

void PathBatch::assign(const TileRays& rays) {
  assign(rays.directions, rays.lengths);
  if (rays.offsets.empty()) return;
  for (auto* offset : {&offset_x, &offset_y, &offset_z}) offset->assign(padded_size(), 0.0f);
  for (std::size_t k = 0; k < rays.offsets.size(); ++k) {
    const glm::vec3 offset(rays.offsets[k]);
    offset_x[k] = offset.x;
    offset_y[k] = offset.y;
    offset_z[k] = offset.z;
  }
}

void PathBatch::make_endless() {
  std::ranges::fill(length, std::numeric_limits<float>::infinity());
}

void PathBatch::assign(const glm::dvec3& origin, std::span<const glm::dvec3> ends,
                       std::span<const std::int32_t> self_of) {
  resize(ends.size());
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const glm::dvec3 q = ends[k] - origin;
    const double distance = glm::length(q);
    if (!(distance > 0.0)) continue;
    const glm::vec3 w(q / distance);
    x[k] = w.x;
    y[k] = w.y;
    z[k] = w.z;
    length[k] = static_cast<float>(distance);
    self[k] = self_of[k];
  }
}

}  // namespace brume
#endif
