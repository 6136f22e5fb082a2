#include "render/shading/area_highlight.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/scene/lights/area_lights.h"
#include "core/scene/materials/ggx.h"
#include "render/geometry/even_points.h"
#include "render/simd/coefficients.h"
#include "render/visibility/light_shapes.h"

namespace brume {
namespace {

constexpr auto rays_over_lobe = static_cast<int>(coefficient::highlight_rays);
// Where rays meet the light with less than this share, its points do.
constexpr double min_share = 0.02;

// The greatest solid angle that one of the light's points stands for at x [sr].
double solid_angle(const PointLight& light, const glm::dvec3& x) {
  const double distance = glm::distance(x, light.area_center) - bounding_radius(*light.area);
  return area_of_point(light) / std::pow(std::max(distance, light.radius), 2.0);
}

}  // namespace

void add_area_highlight(const SurfacePoints& points, const RayCaster& ray_caster,
                        const PointLight& light, const AreaSum& of_points,
                        PointRadiance& radiance) {
  const glm::dvec3 emitted = light.intensity / area_of_point(light);
  const double radius = bounding_radius(*light.area);
  for (std::size_t k = 0; k < points.count; ++k) {
    if (!(points.ggx.alpha[k] < float{GgxReflection::max_mirror_alpha})) continue;
    const auto alpha = static_cast<double>(points.ggx.alpha[k]);
    const glm::dvec3 start = points.origin + points.shadow_origin[k];
    const double densest = rays_over_lobe / (4.0 * std::numbers::pi * alpha * alpha);
    if (densest * solid_angle(light, start) < min_share) continue;
    const glm::dvec3 n = points.normal[k];
    const glm::dvec3 wo = points.to_eye[k];
    GgxReflection reflection;
    reflection.f0 = points.ggx.f0[k];
    reflection.alpha = alpha;
    glm::dvec3 sum(0.0);
    for (int j = 0; j < rays_over_lobe; ++j) {
      const glm::dvec3 wi = sample_ggx(alpha, wo, n, even_point(j, rays_over_lobe));
      const double cosine = glm::dot(wi, n);
      if (!(cosine > 0.0)) continue;
      const auto hit = hit_area(*light.area, light.area_center, start, wi);
      if (!hit) continue;
      const double density = rays_over_lobe * ggx_pdf(alpha, wi, wo, n);
      // A sphere's isotropic points lie around its middle.
      const double piece =
          area_of_point(light) * (light.falloff.is_isotropic()
                                      ? 1.0 / std::pow(glm::distance(start, light.area_center), 2.0)
                                      : hit->cosine / (hit->distance * hit->distance));
      if (!(density > 0.0)) continue;
      const double passes =
          ray_caster.transmittance(start, wi, hit->distance - light_margin(*hit, radius));
      sum += passes * cosine * piece / (1.0 + density * piece) * ggx_brdf(reflection, wi, wo, n);
    }
    const glm::vec3 highlight(static_cast<double>(of_points.transmittance(k)) * emitted * sum);
    radiance.add(k, highlight);
  }
}

}  // namespace brume
