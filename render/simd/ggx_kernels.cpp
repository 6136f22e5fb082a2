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
HWY_INLINE V Square(V x) {
  return hn::Mul(x, x);
}

// D V: what microfacets reflect, without Fresnel's term.
HWY_INLINE V Microfacets(const Vector& n, const Vector& h, V cos_light, V cos_eye, V alpha) {
  const V one = Set(1.0f);
  const V alpha2 = Square(alpha);
  // 1 - (N.H)^2 has no digits where highlights are: the sine of the angle has.
  const Vector cross{hn::MulSub(n.y, h.z, hn::Mul(n.z, h.y)),
                     hn::MulSub(n.z, h.x, hn::Mul(n.x, h.z)),
                     hn::MulSub(n.x, h.y, hn::Mul(n.y, h.x))};
  const V sine2 = hn::Min(dot(cross, cross), one);
  const V spread = hn::MulAdd(alpha2, hn::Sub(one, sine2), sine2);
  const V distribution = hn::Div(alpha2, hn::Mul(Set(std::numbers::pi_v<float>), Square(spread)));
  const auto root = [&](V cosine) HWY_ATTR {
    return hn::Sqrt(hn::MulAdd(hn::Sub(one, alpha2), Square(cosine), alpha2));
  };
  const V visibility =
      hn::Div(Set(0.5f), hn::MulAdd(cos_light, root(cos_eye), hn::Mul(cos_eye, root(cos_light))));
  return hn::Mul(distribution, visibility);
}

}  // namespace ggx

void AddGgxLight(const SurfacePoints& points, const LightAtPoints& light,
                 const glm::vec3& intensity, PointRadiance& radiance) {
  const D d;
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0f);
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    const V cos_light = ggx::Load(light.cosine, i);
    const auto lit = hn::And(hn::Gt(cos_light, zero), hn::Gt(ggx::Load(light.lit, i), zero));
    if (hn::AllFalse(d, lit)) continue;
    const V incoming =
        hn::IfThenElseZero(lit, hn::Mul(hn::Mul(cos_light, ggx::Load(light.inverse_square, i)),
                                        hn::Exp(d, hn::Neg(ggx::Load(light.depths, i)))));
    const Vector n = ggx::Load(points.normal, i);
    const Vector wo = ggx::Load(points.to_eye, i);
    const Vector sum{hn::Sub(wo.x, hn::LoadU(d, light.paths.x.data() + i)),
                     hn::Sub(wo.y, hn::LoadU(d, light.paths.y.data() + i)),
                     hn::Sub(wo.z, hn::LoadU(d, light.paths.z.data() + i))};
    const V length = hn::Sqrt(dot(sum, sum));
    const auto has_half = hn::Gt(length, hn::Set(d, coefficient::tiny));
    const V inverse = hn::IfThenElseZero(has_half, hn::Div(one, length));
    const Vector h{hn::Mul(sum.x, inverse), hn::Mul(sum.y, inverse), hn::Mul(sum.z, inverse)};
    const V cos_eye = hn::Max(dot(n, wo), hn::Set(d, static_cast<float>(min_ggx_cosine)));
    const V specular = hn::IfThenElseZero(
        hn::And(lit, has_half),
        ggx::Microfacets(n, h, hn::Max(cos_light, zero), cos_eye, ggx::Load(points.ggx.alpha, i)));
    // V.H is |L + V| / 2.
    const V x = hn::Sub(one, hn::Min(hn::Mul(hn::Set(d, 0.5f), length), one));
    const V s = hn::Mul(ggx::Square(ggx::Square(x)), x);
    const V rest = hn::Sub(one, s);
    const V diffuse = hn::Mul(rest, hn::Set(d, std::numbers::inv_pi_v<float>));
    const auto add = [&](const PointArray& own_diffuse, const PointArray& own_f0, float channel,
                         PointArray& result) HWY_ATTR {
      const V fresnel = hn::MulAdd(ggx::Load(own_f0, i), rest, s);
      const V f = hn::MulAdd(specular, fresnel, hn::Mul(diffuse, ggx::Load(own_diffuse, i)));
      hn::Store(hn::MulAdd(hn::Mul(incoming, f), hn::Set(d, channel), ggx::Load(result, i)), d,
                result.data() + i);
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

void add_ggx_light(const SurfacePoints& points, const LightAtPoints& light,
                   const glm::vec3& intensity, PointRadiance& radiance) {
  HWY_DYNAMIC_DISPATCH(AddGgxLight)(points, light, intensity, radiance);
}

}  // namespace brume
#endif
