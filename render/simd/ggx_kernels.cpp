#include "render/simd/ggx_kernels.h"

#include <numbers>

#include "core/scene/materials/ggx.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/simd/ggx_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/contrib/math/math-inl.h>

#include "render/simd/gaussian-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using Vector = V3<V>;

namespace ggx {

HWY_INLINE V Set(float x) {
  return hn::Set(D(), x);
}
HWY_INLINE V Load(const PointArray& a, std::size_t i) {
  return hn::Load(D(), a.data() + i);
}
HWY_INLINE Vector Load(const PointVectors& v, std::size_t i) {
  return {Load(v.x, i), Load(v.y, i), Load(v.z, i)};
}

}  // namespace ggx

void AddGgxLight(const SurfacePoints& points, const PointLight& source, const LightAtPoints& light,
                 PointRadiance& radiance) {
  const D d;
  const glm::vec3 intensity(source.intensity);
  const auto area = static_cast<float>(area_of_point(source));
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0f);
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    const V cos_light = ggx::Load(light.cosine, i);
    const auto lit = hn::And(cos_light > zero, ggx::Load(light.lit, i) > zero);
    if (hn::AllFalse(d, lit)) continue;
    const V incoming = where(lit, cos_light * ggx::Load(light.inverse_square, i) *
                                      exp(-ggx::Load(light.depths, i)) * ggx::Load(light.lit, i));
    const Vector n = ggx::Load(points.normal, i);
    const Vector wo = ggx::Load(points.to_eye, i);
    const Vector sum{wo.x - hn::LoadU(d, light.paths.x.data() + i),
                     wo.y - hn::LoadU(d, light.paths.y.data() + i),
                     wo.z - hn::LoadU(d, light.paths.z.data() + i)};
    const V length = sqrt(dot(sum, sum));
    const auto has_half = length > tiny;
    const V inverse = where(has_half, one / length);
    const Vector h{sum.x * inverse, sum.y * inverse, sum.z * inverse};
    const V cos_eye = max(dot(n, wo), static_cast<float>(min_ggx_cosine));
    const V alpha = ggx::Load(points.ggx.alpha, i);
    V share = source.is_seen ? ggx::Load(points.ggx.lobe, i) : one;
    if (area > 0.0f && !source.is_seen) {
      const V alpha2 = alpha * alpha;
      const V density = ggx_ray_density(ggx_distribution(n, h, alpha2), cos_eye, alpha2);
      const V of_points =
          one / mul_add(highlight_rays * density, area * ggx::Load(light.inverse_square, i), one);
      share = select(alpha < GgxReflection::max_mirror_alpha, of_points, one);
    }
    const V specular = share * where(hn::And(lit, has_half),
                                     microfacets(n, h, max(cos_light, zero), cos_eye, alpha));
    const V s = schlick(length);
    const V rest = one - s;
    const V diffuse = rest * std::numbers::inv_pi_v<float>;
    const auto add = [&](const PointArray& own_diffuse, const PointArray& own_f0, float channel,
                         PointArray& result) HWY_ATTR {
      const V fresnel = mul_add(ggx::Load(own_f0, i), rest, s);
      const V f = mul_add(specular, fresnel, diffuse * ggx::Load(own_diffuse, i));
      hn::Store(mul_add(incoming * f, channel, ggx::Load(result, i)), d, result.data() + i);
    };
    add(points.ggx.diffuse.x, points.ggx.f0.x, intensity.r, radiance.r);
    add(points.ggx.diffuse.y, points.ggx.f0.y, intensity.g, radiance.g);
    add(points.ggx.diffuse.z, points.ggx.f0.z, intensity.b, radiance.b);
  }
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(AddGgxLight);

void add_ggx_light(const SurfacePoints& points, const PointLight& source,
                   const LightAtPoints& light, PointRadiance& radiance) {
  HWY_DYNAMIC_DISPATCH(AddGgxLight)(points, source, light, radiance);
}

}  // namespace brume
#endif
