#include "render/simd/surface_kernels.h"

#include <algorithm>

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
void Normalize(std::size_t padded_size, PointVectors& directions) {
  for (std::size_t i = 0; i < padded_size; i += hn::Lanes(D())) {
    store(unit_or_none(load(directions, i)), directions, i);
  }
}

void InterpolatePoints(const PointTriangles& triangles, SurfacePoints& points) {
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(D())) {
    CornersAtPoint<V> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners.positions[k] = load(triangles.position[k], i);
      corners.normals[k] = load(triangles.normal[k], i);
    }
    corners.weights[1] = load(points.u, i);
    corners.weights[2] = load(points.v, i);
    corners.weights[0] = 1.0 - (corners.weights[1] + corners.weights[2]);
    const TrianglePoint<V> point =
        triangle_point(corners, load(points.position, i), load(points.to_eye, i));
    store(point.position, points.position, i);
    store(point.normal, points.normal, i);
    store(point.shadow_origin, points.shadow_origin, i);
    store(point.side, points.side, i);
  }
}

void PointToLight(const SurfacePoints& points, const PointLight& source, LightAtPoints& light) {
  const D d;
  const glm::vec3 position(source.position - points.origin);
  const auto radius = static_cast<float>(source.radius);
  light.paths.resize(points.count);
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    const Vector q = load(points.position, i) - set(position);
    const V square = dot(q, q);
    const auto is_distinct = square > tiny;
    const V inverse = where(is_distinct, 1.0f / sqrt(square));
    const Vector from_light = inverse * q;
    hn::StoreU(from_light.x, d, light.paths.x.data() + i);
    hn::StoreU(from_light.y, d, light.paths.y.data() + i);
    hn::StoreU(from_light.z, d, light.paths.z.data() + i);
    hn::StoreU(square * inverse, d, light.paths.length.data() + i);
    store(-dot(from_light, load(points.normal, i)), light.cosine, i);
    V arriving = where(is_distinct, 1.0f / max(square, radius * radius));
    if (!source.falloff.is_isotropic()) {
      const FalloffFloats floats(source.falloff);
      const V sent = floats.At(floats.Components(from_light));
      const V seen = source.area_points == 1 ? where(sent > least_of_area, sent) : sent;
      arriving *= source.area_points > 1 ? max(sent, least_of_area) : seen;
    }
    store(arriving, light.inverse_square, i);
  }
}

HWY_INLINE void add(V x, const glm::vec3& color, PointRadiance& radiance, std::size_t i) {
  store(mul_add(x, color.r, load(radiance.r, i)), radiance.r, i);
  store(mul_add(x, color.g, load(radiance.g, i)), radiance.g, i);
  store(mul_add(x, color.b, load(radiance.b, i)), radiance.b, i);
}

void AddDirectLight(const SurfacePoints& points, const LightAtPoints& light,
                    const PointLightShading& shading, PointRadiance& radiance) {
  const D d;
  const V zero = hn::Zero(d);
  const bool shines = shading.highlight != glm::vec3(0.0f);
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    const V cosine = load(light.cosine, i);
    const auto lit = hn::And(cosine > zero, load(light.lit, i) > zero);
    if (hn::AllFalse(d, lit)) continue;
    const V incoming = where(lit, cosine * load(light.inverse_square, i) *
                                      exp(-load(light.depths, i)) * load(light.lit, i));
    add(incoming, shading.diffuse * shading.intensity, radiance, i);
    if (!shines) continue;
    const Vector w{hn::LoadU(d, light.paths.x.data() + i), hn::LoadU(d, light.paths.y.data() + i),
                   hn::LoadU(d, light.paths.z.data() + i)};
    const Vector to_eye = load(points.to_eye, i);
    // w mirrored at the normal, times the direction to the eye.
    const V r = mul_add(cosine + cosine, dot(load(points.normal, i), to_eye), dot(w, to_eye));
    const V lobe = phong_lobe(r, set(shading.exponent));
    add(where(r > zero, incoming * lobe), shading.highlight * shading.intensity, radiance, i);
  }
}

HWY_INLINE V Polynomial(V x, const std::array<float, ScatterTable::degree + 1>& coefficient) {
  V p = set(coefficient[0]);
  for (std::size_t i = 1; i < coefficient.size(); ++i) p = mul_add(p, x, coefficient[i]);
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
    const V homogeneous = spread.density * hn::LoadU(d, light.paths.length.data() + i);
    const V homogeneous_fraction = select(homogeneous < depth, homogeneous / depth, one);
    const auto has_scattering = hn::And(depth > zero, depth < ScatterTable::opaque);
    const V T = where(has_scattering, depth);
    const V x = scatter_position(T);
    const V once = T * exp(-T);
    for (std::size_t l = 0; l < sh_max_bands; ++l) {
      if (diffuse_only && (l == 3 || l == 5)) continue;
      const V of_distant = Polynomial(x, far[l]);
      const V of_point = Polynomial(x, near[l]);
      const V both = mul_add(homogeneous_fraction, of_point - of_distant, of_distant);
      store(once * both, factors[l], i);
    }
  }
}

void AddScatteredLight(const SurfacePoints& points, const LightAtPoints& light,
                       const std::array<PointArray, sh_max_bands>& factors,
                       const PointLightShading& shading, PointRadiance& radiance) {
  const D d;
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    const V x = load(light.cosine, i);
    const V irradiance = band_irradiance(x, load(factors[0], i), load(factors[1], i),
                                         load(factors[2], i), load(factors[4], i));
    add(max(irradiance, 0.0f) * load(light.inverse_square, i), shading.diffuse * shading.intensity,
        radiance, i);
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
    const glm::dvec3 w =
        rays.is_parallel() ? rays.forward() : corner + position.x * per_x + position.y * per_y;
    directions.x[k] = static_cast<float>(w.x);
    directions.y[k] = static_cast<float>(w.y);
    directions.z[k] = static_cast<float>(w.z);
  }
  HWY_DYNAMIC_DISPATCH(Normalize)(padded(pixels.size()), directions);
}

void interpolate_points(const PointTriangles& triangles, SurfacePoints& points) {
  HWY_DYNAMIC_DISPATCH(InterpolatePoints)(triangles, points);
}

void point_to_light(const SurfacePoints& points, const PointLight& source, LightAtPoints& light) {
  HWY_DYNAMIC_DISPATCH(PointToLight)(points, source, light);
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
