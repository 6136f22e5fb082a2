#include "render/cpu/march_kernels.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/march_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/gaussian-inl.h"
#include "render/simd/noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using Vector = V3<V>;

HWY_INLINE V set(float x) {
  return hn::Set(D(), x);
}

template <BatchKind kKind, class Rays>
HWY_INLINE std::uint64_t Samples(const GaussianBatch& g, const PathBatch& paths, const float* t,
                                 float* densities, float* depths) {
  const D d;
  std::uint64_t pairs = 0;
  for (std::size_t k = 0; k < paths.padded_size(); k += hn::Lanes(d)) {
    const Rays rays(d, paths, k);
    const V distance = hn::LoadU(d, t + k);
    V density = hn::Zero(d);
    V depth = hn::Zero(d);
    for (std::size_t j = 0; j < g.size(); ++j) {
      const LineProfile<V> line = BatchLineProfile<kKind>(d, g, j, rays);
      const auto reached = line.e <= g.max_e[j];
      if (hn::AllFalse(d, reached)) continue;
      pairs += hn::CountTrue(d, reached);
      // Nothing beyond the cutoff, whatever rays share a vector.
      const V half_depth = where(reached, BatchHalfDepth<kKind>(d, g, j, line));
      depth = mul_add(half_depth, unit_depth(line, distance), depth);
      const V u = line.a * (distance - line.t0);
      constexpr float two_over_sqrt_pi = 1.12837916709551257f;
      const V peak = half_depth * (line.a * two_over_sqrt_pi);
      density = mul_add(peak, exp(-mul_add(u, u, line.e)), density);
    }
    hn::StoreU(density, d, densities + k);
    hn::StoreU(depth, d, depths + k);
  }
  return pairs;
}

std::uint64_t SampleMedium(const GaussianBatch& g, const PathBatch& rays, const float* t,
                           float* densities, float* depths) {
  return WithRays(D(), rays, [&]<class Rays>() HWY_ATTR {
    return with_kind(g, [&]<BatchKind kKind>() HWY_ATTR {
      return Samples<kKind, Rays>(g, rays, t, densities, depths);
    });
  });
}

template <class Rays>
HWY_INLINE void Scattered(const PathBatch& paths, const LitSamples& samples, const glm::vec3& light,
                          float h_min, float anisotropy, float* radiance) {
  const D d;
  const V least2 = set(h_min * h_min);
  for (std::size_t k = 0; k < paths.padded_size(); k += hn::Lanes(d)) {
    const V weight = hn::LoadU(d, samples.weights + k);
    const auto is_lit = weight > 0.0f;
    if (hn::AllFalse(d, is_lit)) continue;
    const Rays rays(d, paths, k);
    const Vector& w = rays.w;
    const Vector s = rays.From({set(light.x), set(light.y), set(light.z)});
    const V ts = dot(s, w);
    const Vector offset = neg_mul_add(ts, w, s);
    const V offset2 = dot(offset, offset);
    const V along = hn::LoadU(d, samples.t + k) - ts;
    // The path is as long as it is; only the falloff has a least distance (PointLightRay).
    const V distance2 = max(mul_add(along, along, max(offset2, least2)), tiny);
    const V true_distance = sqrt(max(mul_add(along, along, offset2), tiny));
    const V depth = hn::LoadU(d, samples.depths + k) + hn::LoadU(d, samples.light_depths + k);
    V value = weight * exp(-depth) / distance2;
    if (anisotropy != 0.0f) {
      value *= henyey_greenstein(cos_theta(along, true_distance), anisotropy);
    }
    const V sum = mul_add(isotropic_phase, where(is_lit, value), hn::LoadU(d, radiance + k));
    hn::StoreU(sum, d, radiance + k);
  }
}

void AddScattered(const PathBatch& rays, const LitSamples& samples, const glm::vec3& light,
                  float h_min, float anisotropy, float* radiance) {
  WithRays(D(), rays, [&]<class Rays>() HWY_ATTR {
    Scattered<Rays>(rays, samples, light, h_min, anisotropy, radiance);
  });
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(SampleMedium);
HWY_EXPORT(AddScattered);

std::uint64_t sample_medium(const GaussianBatch& gaussians, const PathBatch& rays, const float* t,
                            float* densities, float* depths) {
  return HWY_DYNAMIC_DISPATCH(SampleMedium)(gaussians, rays, t, densities, depths);
}

void add_scattered(const PathBatch& rays, const LitSamples& samples, const glm::vec3& light,
                   float h_min, float anisotropy, float* radiance) {
  HWY_DYNAMIC_DISPATCH(AddScattered)(rays, samples, light, h_min, anisotropy, radiance);
}

}  // namespace brume
#endif
