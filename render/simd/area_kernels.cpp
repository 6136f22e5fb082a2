#include "render/simd/area_kernels.h"

#include "core/scene/lights/area_lights.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/simd/area_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/formulas-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

namespace area_lights {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using Vector = V3<V>;

HWY_INLINE Vector Set(const glm::vec3& v) {
  return {hn::Set(D(), v.x), hn::Set(D(), v.y), hn::Set(D(), v.z)};
}
HWY_INLINE V Load(const PointArray& a, std::size_t i) {
  return hn::Load(D(), a.data() + i);
}
HWY_INLINE Vector Load(const PointVectors& v, std::size_t i) {
  return {Load(v.x, i), Load(v.y, i), Load(v.z, i)};
}

HWY_INLINE V Irradiance(const AreaShape& area, const Vector& position, const Vector& n) {
  const D d;
  const V zero = hn::Zero(d);
  if (area.corners.empty()) {
    const Vector to_center = Set(area.center) - position;
    const auto is_within = dot(to_center, to_center) <= area.radius * area.radius;
    return select(is_within, hn::Set(d, area.is_two_sided ? static_cast<float>(pi) : 0.0f),
                  sphere_irradiance(to_center, n, area.radius));
  }
  PolygonLight<V> light = no_polygon_light(zero);
  Vector corner = Set(area.corners.back()) - position;
  for (const glm::vec3& next : area.corners) {
    const Vector next_corner = Set(next) - position;
    light = with_edge(light, corner, next_corner, n);
    corner = next_corner;
  }
  const V sum = polygon_irradiance(light, n);
  return area.is_two_sided ? abs(sum) : max(sum, zero);
}

}  // namespace area_lights

void AddIrradiance(const SurfacePoints& points, const LightAtPoints& light, float area,
                   PointArray& irradiance, PointArray& attenuated) {
  using namespace area_lights;
  const D d;
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    const V arriving =
        max(Load(light.cosine, i), hn::Zero(d)) * (Load(light.inverse_square, i) * area);
    hn::Store(Load(irradiance, i) + arriving, d, irradiance.data() + i);
    hn::Store(mul_add(arriving, exp(-Load(light.depths, i)), Load(attenuated, i)), d,
              attenuated.data() + i);
  }
}

void AddArea(const SurfacePoints& points, const AreaShape& area, const PointArray& irradiance,
             const PointRadiance& radiance, PointRadiance& whole) {
  using namespace area_lights;
  const D d;
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    const V of_points = Load(irradiance, i);
    const auto is_lit = of_points > tiny;
    if (hn::AllFalse(d, is_lit)) continue;
    const Vector position = Load(points.position, i);
    const Vector to_center = Set(area.center) - position;
    const auto is_far = dot(to_center, to_center) > area.far2;
    const V all =
        hn::AllTrue(d, is_far) ? of_points : Irradiance(area, position, Load(points.normal, i));
    const V factor = where(is_lit, select(is_far, of_points, all) / of_points);
    const auto add = [&](const PointArray& from, PointArray& to) HWY_ATTR {
      hn::Store(mul_add(factor, Load(from, i), Load(to, i)), d, to.data() + i);
    };
    add(radiance.r, whole.r);
    add(radiance.g, whole.g);
    add(radiance.b, whole.b);
  }
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(AddIrradiance);
HWY_EXPORT(AddArea);

AreaShape::AreaShape(const AreaLight& area, const glm::dvec3& area_center, const glm::dvec3& origin)
    : center(area_center - origin),
      is_two_sided(brume::is_two_sided(area)),
      far2(static_cast<float>(coefficient::far_areas * facing_area(area))) {
  const AreaOutline outline(area, area_center, coefficient::disk_corners);
  for (int k = 0; k < outline.corner_count; ++k) corners.emplace_back(outline.corner(k) - origin);
  if (const auto* sphere = std::get_if<light::Sphere>(&area)) {
    radius = static_cast<float>(sphere->radius);
  }
}

void AreaSum::clear() {
  for (PointArray* values : {&radiance.r, &radiance.g, &radiance.b, &irradiance_, &attenuated_}) {
    values->fill(0.0f);
  }
}

void AreaSum::add(const SurfacePoints& points, const LightAtPoints& light, float area) {
  HWY_DYNAMIC_DISPATCH(AddIrradiance)(points, light, area, irradiance_, attenuated_);
}

void AreaSum::add_to(const SurfacePoints& points, const AreaShape& area,
                     PointRadiance& whole) const {
  HWY_DYNAMIC_DISPATCH(AddArea)(points, area, irradiance_, radiance, whole);
}

}  // namespace brume
#endif
