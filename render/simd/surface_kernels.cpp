#include "render/simd/surface_kernels.h"
#include "core/scene/camera_rays.h"

#include <algorithm>

#include "render/geometry/rounding.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/simd/surface_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/falloff-inl.h"
#include "render/simd/gaussian-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using Vector = V3<V>;

HWY_INLINE V set(float x) {
  return hn::Set(D(), x);
}
HWY_INLINE Vector set(const glm::vec3& v) {
  return {set(v.x), set(v.y), set(v.z)};
}
HWY_INLINE V load(const PointArray& a, std::size_t i) {
  return hn::Load(D(), a.data() + i);
}
HWY_INLINE Vector load(const PointVectors& v, std::size_t i) {
  return {load(v.x, i), load(v.y, i), load(v.z, i)};
}
HWY_INLINE void store(V x, PointArray& a, std::size_t i) {
  hn::Store(x, D(), a.data() + i);
}
HWY_INLINE void store(const Vector& v, PointVectors& to, std::size_t i) {
  store(v.x, to.x, i);
  store(v.y, to.y, i);
  store(v.z, to.z, i);
}
HWY_INLINE Vector times(V s, const Vector& v) {
  return {hn::Mul(s, v.x), hn::Mul(s, v.y), hn::Mul(s, v.z)};
}
HWY_INLINE Vector minus(const Vector& a, const Vector& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
// a + s b
HWY_INLINE Vector plus(const Vector& a, V s, const Vector& b) {
  return {hn::MulAdd(s, b.x, a.x), hn::MulAdd(s, b.y, a.y), hn::MulAdd(s, b.z, a.z)};
}
HWY_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
// Unit, or 0 where `v` is too short.
HWY_INLINE Vector normalized(const Vector& v) {
  const V square = dot(v, v);
  const V inverse = hn::Div(set(1.0f), hn::Sqrt(hn::Max(square, set(coefficient::tiny_square))));
  return times(hn::IfThenElseZero(hn::Gt(square, set(coefficient::tiny_square)), inverse), v);
}
HWY_INLINE Vector choose(hn::Mask<D> mask, const Vector& yes, const Vector& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}

void Normalize(std::size_t padded_size, PointVectors& directions) {
  for (std::size_t i = 0; i < padded_size; i += hn::Lanes(D())) {
    const Vector w{load(directions.x, i), load(directions.y, i), load(directions.z, i)};
    store(normalized(w), directions, i);
  }
}

HWY_INLINE V max_component(const Vector& v) {
  return hn::Max(v.x, hn::Max(v.y, v.z));
}
HWY_INLINE Vector abs(const Vector& v) {
  return {hn::Abs(v.x), hn::Abs(v.y), hn::Abs(v.z)};
}
HWY_INLINE Vector max(const Vector& a, const Vector& b) {
  return {hn::Max(a.x, b.x), hn::Max(a.y, b.y), hn::Max(a.z, b.z)};
}

// off_plane_rounding()
HWY_INLINE V OffPlaneRounding(const Vector& normal, const Vector& sizes) {
  const V rounding = set(static_cast<float>(position_rounding));
  return hn::Mul(rounding, hn::MulAdd(rounding, max_component(sizes), dot(abs(normal), sizes)));
}

void InterpolatePoints(const PointTriangles& triangles, SurfacePoints& points) {
  const D d;
  const V zero = hn::Zero(d);
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    const V u = load(points.u, i);
    const V v = load(points.v, i);
    const V weights[] = {hn::Sub(set(1.0f), hn::Add(u, v)), u, v};
    const Vector corners[] = {load(triangles.position[0], i), load(triangles.position[1], i),
                              load(triangles.position[2], i)};
    const Vector normals[] = {load(triangles.normal[0], i), load(triangles.normal[1], i),
                              load(triangles.normal[2], i)};
    const Vector along = minus(corners[1], corners[0]);
    const Vector across = minus(corners[2], corners[0]);
    const Vector smooth = normalized(
        plus(plus(times(weights[0], normals[0]), weights[1], normals[1]), weights[2], normals[2]));
    // Lengthened first: the product of two short edges would vanish.
    Vector geometric = normalized(cross(normalized(along), normalized(across)));
    Vector normal = choose(hn::Gt(dot(smooth, smooth), zero), smooth, geometric);
    const Vector w = load(points.to_eye, i);
    const V faces = hn::CopySign(set(1.0f), dot(geometric, w));
    geometric = times(faces, geometric);
    const V side = hn::IfThenElse(hn::Lt(dot(normal, geometric), zero), set(-1.0f), set(1.0f));
    normal = times(side, normal);
    Vector p = load(points.position, i);
    p = plus(p, hn::Neg(dot(minus(p, corners[0]), geometric)), geometric);
    const Vector sizes = max(abs(corners[0]), max(abs(corners[1]), abs(corners[2])));
    Vector shadow = plus(p, OffPlaneRounding(geometric, sizes), geometric);
    for (std::size_t k = 0; k < 3; ++k) {
      // How far the point lies below the tangent plane of a corner.
      const Vector n = times(side, normals[k]);
      const V below = hn::Min(dot(minus(p, corners[k]), n), zero);
      shadow = plus(shadow, hn::Neg(hn::Mul(weights[k], below)), n);
    }
    store(p, points.position, i);
    store(normal, points.normal, i);
    store(shadow, points.shadow_origin, i);
    store(side, points.side, i);
  }
}

void PointToLight(const SurfacePoints& points, const glm::vec3& position,
                  const LightFalloff& falloff, float radius, LightAtPoints& light) {
  const D d;
  light.paths.resize(points.count);
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    const Vector q = minus(load(points.position, i), set(position));
    const V square = dot(q, q);
    const auto is_distinct = hn::Gt(square, set(coefficient::tiny));
    const V inverse = hn::IfThenElseZero(is_distinct, hn::Div(set(1.0f), hn::Sqrt(square)));
    const Vector from_light = times(inverse, q);
    hn::StoreU(from_light.x, d, light.paths.x.data() + i);
    hn::StoreU(from_light.y, d, light.paths.y.data() + i);
    hn::StoreU(from_light.z, d, light.paths.z.data() + i);
    hn::StoreU(hn::Mul(square, inverse), d, light.paths.length.data() + i);
    store(hn::Neg(dot(from_light, load(points.normal, i))), light.cosine, i);
    V arriving =
        hn::IfThenElseZero(is_distinct, hn::Div(set(1.0f), hn::Max(square, set(radius * radius))));
    if (!falloff.is_isotropic()) {
      const FalloffFloats floats(falloff);
      arriving = hn::Mul(arriving, floats.Towards(from_light));
    }
    store(arriving, light.inverse_square, i);
  }
}

HWY_INLINE void add(V x, const glm::vec3& color, PointRadiance& radiance, std::size_t i) {
  store(hn::MulAdd(x, set(color.r), load(radiance.r, i)), radiance.r, i);
  store(hn::MulAdd(x, set(color.g), load(radiance.g, i)), radiance.g, i);
  store(hn::MulAdd(x, set(color.b), load(radiance.b, i)), radiance.b, i);
}

void AddDirectLight(const SurfacePoints& points, const LightAtPoints& light,
                    const PointLightShading& shading, PointRadiance& radiance) {
  const D d;
  const V zero = hn::Zero(d);
  const bool shines = shading.highlight != glm::vec3(0.0f);
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    const V cosine = load(light.cosine, i);
    const auto lit = hn::And(hn::Gt(cosine, zero), hn::Gt(load(light.lit, i), zero));
    if (hn::AllFalse(d, lit)) continue;
    const V incoming =
        hn::IfThenElseZero(lit, hn::Mul(hn::Mul(cosine, load(light.inverse_square, i)),
                                        hn::Exp(d, hn::Neg(load(light.depths, i)))));
    add(incoming, shading.diffuse * shading.intensity, radiance, i);
    if (!shines) continue;
    const Vector w{hn::LoadU(d, light.paths.x.data() + i), hn::LoadU(d, light.paths.y.data() + i),
                   hn::LoadU(d, light.paths.z.data() + i)};
    const Vector to_eye = load(points.to_eye, i);
    // w mirrored at the normal, times the direction to the eye.
    const V r =
        hn::MulAdd(hn::Add(cosine, cosine), dot(load(points.normal, i), to_eye), dot(w, to_eye));
    const V lobe =
        hn::Exp(d, hn::Mul(set(shading.exponent),
                           hn::Log(d, hn::Min(hn::Max(r, set(coefficient::tiny)), set(1.0f)))));
    add(hn::IfThenElseZero(hn::Gt(r, zero), hn::Mul(incoming, lobe)),
        shading.highlight * shading.intensity, radiance, i);
  }
}

HWY_INLINE V Polynomial(V x, const std::array<float, ScatterTable::degree + 1>& coefficient) {
  V p = set(coefficient[0]);
  for (std::size_t i = 1; i < coefficient.size(); ++i) p = hn::MulAdd(p, x, set(coefficient[i]));
  return p;
}

void FindSpread(const LightAtPoints& light, std::size_t padded_size, const LightSpread& spread,
                bool diffuse_only, std::array<PointArray, sh_max_bands>& factors) {
  const D d;
  const V zero = hn::Zero(d);
  const V one = set(1.0f);
  const ScatterTable::Polynomials& near = spread.point->polynomials();
  const ScatterTable::Polynomials& far = spread.distant->polynomials();
  for (std::size_t i = 0; i < padded_size; i += hn::Lanes(d)) {
    const V depth = load(light.depths, i);
    const V homogeneous = hn::Mul(set(spread.density), hn::LoadU(d, light.paths.length.data() + i));
    const V homogeneous_fraction =
        hn::IfThenElse(hn::Lt(homogeneous, depth), hn::Div(homogeneous, depth), one);
    const auto has_scattering =
        hn::And(hn::Gt(depth, zero), hn::Lt(depth, set(ScatterTable::opaque)));
    const V T = hn::IfThenElseZero(has_scattering, depth);
    const V root = hn::Sqrt(T);
    const V x = hn::Sub(hn::Mul(set(ScatterTable::scale), hn::Div(root, hn::Add(root, one))), one);
    const V once = hn::Mul(T, hn::Exp(d, hn::Neg(T)));
    for (std::size_t l = 0; l < sh_max_bands; ++l) {
      if (diffuse_only && (l == 3 || l == 5)) continue;
      const V of_distant = Polynomial(x, far[l]);
      const V of_point = Polynomial(x, near[l]);
      const V both = hn::MulAdd(homogeneous_fraction, hn::Sub(of_point, of_distant), of_distant);
      store(hn::Mul(once, both), factors[l], i);
    }
  }
}

void AddScatteredLight(const SurfacePoints& points, const LightAtPoints& light,
                       const std::array<PointArray, sh_max_bands>& factors,
                       const PointLightShading& shading, PointRadiance& radiance) {
  const D d;
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    // sh_convolve() of the light's bands with clamped_cosine_sh(), written out.
    const V x = load(light.cosine, i);
    const V x2 = hn::Mul(x, x);
    const V p2 = Horner(d, x2, coefficient::legendre_2);
    const V p4 = Horner(d, x2, coefficient::legendre_4);
    using coefficient::irradiance_bands;
    V irradiance = hn::Mul(set(irradiance_bands[0]), load(factors[0], i));
    irradiance = hn::MulAdd(hn::Mul(set(irradiance_bands[1]), x), load(factors[1], i), irradiance);
    irradiance = hn::MulAdd(hn::Mul(set(irradiance_bands[2]), p2), load(factors[2], i), irradiance);
    irradiance = hn::MulAdd(hn::Mul(set(irradiance_bands[3]), p4), load(factors[4], i), irradiance);
    add(hn::Mul(hn::Max(irradiance, hn::Zero(d)), load(light.inverse_square, i)),
        shading.diffuse * shading.intensity, radiance, i);
  }
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(Normalize);
HWY_EXPORT(InterpolatePoints);
HWY_EXPORT(PointToLight);
HWY_EXPORT(AddDirectLight);
HWY_EXPORT(FindSpread);
HWY_EXPORT(AddScatteredLight);

void find_view_directions(const CameraRays& rays, std::span<const glm::ivec2> pixels,
                          PointVectors& directions) {
  // In double each by itself: no digits are lost on large films, whichever pixels are together.
  const auto [corner, per_x, per_y] = rays.plane();
  const glm::dvec2 first = glm::dvec2(rays.first_pixel()) + 0.5;
  for (std::size_t k = 0; k < padded(pixels.size()); ++k) {
    const glm::dvec2 position = first + glm::dvec2(pixels[std::min(k, pixels.size() - 1)]);
    const glm::dvec3 w = corner + position.x * per_x + position.y * per_y;
    directions.x[k] = static_cast<float>(w.x);
    directions.y[k] = static_cast<float>(w.y);
    directions.z[k] = static_cast<float>(w.z);
  }
  HWY_DYNAMIC_DISPATCH(Normalize)(padded(pixels.size()), directions);
}

void interpolate_points(const PointTriangles& triangles, SurfacePoints& points) {
  HWY_DYNAMIC_DISPATCH(InterpolatePoints)(triangles, points);
}

void point_to_light(const SurfacePoints& points, const glm::vec3& position,
                    const LightFalloff& falloff, float radius, LightAtPoints& light) {
  HWY_DYNAMIC_DISPATCH(PointToLight)(points, position, falloff, radius, light);
}

void add_direct_light(const SurfacePoints& points, const LightAtPoints& light,
                      const PointLightShading& shading, PointRadiance& radiance) {
  HWY_DYNAMIC_DISPATCH(AddDirectLight)(points, light, shading, radiance);
}

void find_spread(const LightAtPoints& light, std::size_t padded_size, const LightSpread& spread,
                 bool diffuse_only, std::array<PointArray, sh_max_bands>& factors) {
  HWY_DYNAMIC_DISPATCH(FindSpread)(light, padded_size, spread, diffuse_only, factors);
}

void add_scattered_light(const SurfacePoints& points, const LightAtPoints& light,
                         const std::array<PointArray, sh_max_bands>& factors,
                         const PointLightShading& shading, PointRadiance& radiance) {
  HWY_DYNAMIC_DISPATCH(AddScatteredLight)(points, light, factors, shading, radiance);
}

}  // namespace brume
#endif
