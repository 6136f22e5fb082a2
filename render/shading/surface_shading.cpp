#include "render/shading/surface_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/scene/lights/area_lights.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/materials/brdf.h"
#include "core/scene/materials/ggx.h"
#include "render/geometry/even_points.h"
#include "render/optical_depth/path_depths.h"
#include "render/simd/area_kernels.h"
#include "render/simd/coefficients.h"
#include "render/simd/ggx_kernels.h"
#include "render/simd/reflection_kernels.h"
#include "render/slices/slice_kernels.h"
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

// radiance += the highlight of an area light, of which `light` is a point, on what is so smooth
// that its points would show: of rays over the lobe, alike at all points, those that meet the
// light. What the points have of the highlight, and these rays, add up to one by the balance
// heuristic (Veach 1997): see add_ggx_light(). `of_points`: the sum of the light's points.
// Thread-safe.
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

using BandArrays = std::array<PointArray, sh_max_bands>;

// Materials for which brdf() has no kernel, point by point.
void add_measured_light(const SurfacePoints& points, const LightAtPoints& light_at_point,
                        const glm::vec3& intensity, PointRadiance& radiance) {
  for (std::size_t k = 0; k < points.count; ++k) {
    if (!(light_at_point.cosine[k] > 0.0f && light_at_point.lit[k] > 0.0f)) continue;
    const glm::dvec3 wi(-light_at_point.paths.x[k], -light_at_point.paths.y[k],
                        -light_at_point.paths.z[k]);
    const glm::vec3 f(brdf(points.surface->material, wi, points.to_eye[k], points.normal[k]));
    const float incoming = light_at_point.cosine[k] * light_at_point.inverse_square[k] *
                           std::exp(-light_at_point.depths[k]) * light_at_point.lit[k];
    radiance.add(k, f * intensity * incoming);
  }
}

// Indirect light that diffuse surfaces reflect.
void add_diffuse_light(const SurfaceLighting& lighting, const AverageDepthGrid* average_depth,
                       const SurfacePoints& points, PointRadiance& radiance) {
  thread_local PointRadiance sent;
  if (lighting.incident) {
    incident_lookup(lighting, points)
        .diffuse(points, diffuse_factors(lighting.incident_scale, lighting.environment), sent);
  } else {
    for_each_fraction(
        lighting, average_depth, points, [&](std::size_t k, const ScatterTable::Bands& fractions) {
          const glm::vec3 light = lighting.environment->diffuse(points.normal[k], fractions);
          sent.r[k] = light.r;
          sent.g[k] = light.g;
          sent.b[k] = light.b;
        });
  }
  const glm::vec3 reflectance(points.surface->material.reflectance);
  for (std::size_t k = 0; k < points.count; ++k) {
    radiance.add(k, reflectance * sent[k]);
  }
}

// light += light of a point light scattered by the medium, with factors per band.
void add_scattered(const LightAtPoints& light_at_point, const BandArrays& factors,
                   const glm::vec3& intensity, std::size_t count, IncidentLight& light) {
  for (std::size_t k = 0; k < count; ++k) {
    const ShVector<float> direction =
        sh_basis(sh_max_bands, glm::vec3(-light_at_point.paths.x[k], -light_at_point.paths.y[k],
                                         -light_at_point.paths.z[k]));
    for (int l = 0; l < sh_max_bands; ++l) {
      const glm::vec3 band =
          light_at_point.inverse_square[k] * factors[static_cast<std::size_t>(l)][k] * intensity;
      for (int m = -l; m <= l; ++m) {
        light.add(k, sh_index(l, m), direction[sh_index(l, m)] * band);
      }
    }
  }
}

// Non-diffuse materials reflect all indirect light at once. `material`: null of metallic-roughness.
void add_reflected(const SurfacePoints& points, const ShMaterial* material,
                   const IncidentLight& light, PointRadiance& radiance) {
  thread_local PointRadiance outgoing;
  if (material) {
    reflect(points, material->table(), light, outgoing);
  } else {
    reflect_ggx(points, light, outgoing);
  }
  for (std::size_t k = 0; k < points.count; ++k) {
    radiance.add(k, glm::max(outgoing[k], 0.0f));
  }
}

}  // namespace

PointLightShading point_light_shading(const Material& material, const PointSource& light) {
  PointLightShading shading;
  shading.intensity = glm::vec3(light.intensity);
  shading.diffuse = glm::vec3(material.reflectance * std::numbers::inv_pi);
  if (material.type == Material::Type::phong) {
    const double exponent = std::min(material.exponent, 1e30);  // float ends
    shading.highlight =
        glm::vec3(material.specular * ((exponent + 2.0) * 0.5 * std::numbers::inv_pi));
    shading.exponent = static_cast<float>(exponent);
  }
  return shading;
}

std::uint64_t find_depths(const MediumIndex& medium, const SurfaceLight& light,
                          const SurfacePoints& points, Settings::Precision precision,
                          double extinction, LightAtPoints& light_at_point) {
  std::uint64_t pairs = 0;
  if (light.table) {
    lookup_depths(*light.table, light_at_point.paths, light_at_point.depths.data());
  } else {
    std::array<glm::dvec3, Tiles::pixels> ends;
    std::array<double, Tiles::pixels> depths;
    std::array<std::int32_t, Tiles::pixels> none;
    none.fill(-1);
    for (std::size_t k = 0; k < points.count; ++k) ends[k] = points.origin + points.position[k];
    pairs = bundle_depths(medium, light.source.position, std::span(ends).first(points.count),
                          std::span(none).first(points.count), precision,
                          std::span(depths).first(points.count));
    for (std::size_t k = 0; k < points.padded_size(); ++k) {
      light_at_point.depths[k] = static_cast<float>(depths[std::min(k, points.count - 1)]);
    }
  }
  const auto b0 = static_cast<float>(medium.homogeneous_density());
  for (std::size_t k = 0; b0 > 0.0f && k < points.padded_size(); ++k) {
    const std::size_t point = std::min(k, points.count - 1);
    light_at_point.depths[k] +=
        b0 *
        (light.source.fog.is_endless()
             ? light_at_point.paths.length[k]
             : static_cast<float>(light.source.fog_length(points.origin + points.position[point])));
  }
  const auto factor = static_cast<float>(extinction);
  for (std::size_t k = 0; factor != 1.0f && k < points.padded_size(); ++k) {
    light_at_point.depths[k] *= factor;
  }
  return pairs;
}

std::uint64_t surface_radiance(const MediumIndex& medium, const RayCaster& ray_caster,
                               const SurfaceLighting& lighting, const SurfaceShading& shading,
                               const SurfacePoints& points, Settings::Precision precision,
                               PointRadiance& radiance) {
  thread_local LightAtPoints light_at_point;
  thread_local AreaSum area_sum;
  thread_local BandArrays factors;
  thread_local IncidentLight indirect;  // of what is not diffuse
  for (PointArray* channel : {&radiance.r, &radiance.g, &radiance.b}) channel->fill(0.0f);
  const Material& material = points.surface->material;
  const bool is_ggx = material.type == Material::Type::metallic_roughness;
  const bool is_diffuse = !is_ggx && (!shading.material || shading.material->is_diffuse());
  const bool reflects_indirect = !is_diffuse && (lighting.point || lighting.has_indirect());
  if (reflects_indirect) indirect.clear();
  std::uint64_t pairs = 0;
  int area_points = 0;  // that are still to come of an area light
  for (const SurfaceLight& light : lighting.lights) {
    const double area = area_of_point(light.source);
    if (area > 0.0 && area_points == 0) {
      area_points = light.source.area_points;
      area_sum.clear();
    }
    PointRadiance& direct = area > 0.0 ? area_sum.radiance : radiance;
    const glm::vec3 position(light.source.position - points.origin);
    point_to_light(points, light.source, light_at_point);
    pairs += find_depths(medium, light, points, precision, lighting.extinction, light_at_point);
    ray_caster.trace_shadow_rays(points, position, light_at_point);
    PointLightShading reflected = point_light_shading(material, light.source);
    if (material.type == Material::Type::measured) {
      add_measured_light(points, light_at_point, reflected.intensity, direct);
    } else if (is_ggx) {
      add_ggx_light(points, light.source, light_at_point, direct);
    } else {
      add_direct_light(points, light_at_point, reflected, direct);
    }
    if (area > 0.0) {
      area_sum.add(points, light_at_point, static_cast<float>(area));
      if (--area_points == 0) {
        area_sum.add_to(points, {*light.source.area, light.source.area_center, points.origin},
                        radiance);
        if (is_ggx && !light.source.is_seen) {
          add_area_highlight(points, ray_caster, light.source, area_sum, radiance);
        }
      }
    }
    if (!lighting.point) continue;
    find_spread(light_at_point, points.padded_size(),
                {lighting.point, lighting.distant, static_cast<float>(light.density)}, is_diffuse,
                factors);
    reflected.intensity *= static_cast<float>(lighting.albedo);
    if (is_diffuse) {
      add_scattered_light(points, light_at_point, factors, reflected, radiance);
    } else {
      add_scattered(light_at_point, factors, reflected.intensity, points.count, indirect);
    }
  }
  if (lighting.has_indirect() && is_diffuse) {
    add_diffuse_light(lighting, shading.average_depth, points, radiance);
  } else if (lighting.has_indirect()) {
    for_each_incident(lighting, shading.average_depth, points,
                      [&](std::size_t k, const auto& incident) {
                        indirect.add(k, incident_light(lighting, incident));
                      });
  }
  if (reflects_indirect) {
    add_reflected(points, is_ggx ? nullptr : shading.material, indirect, radiance);
  }
  for (std::size_t k = 0; is_ggx && k < points.count; ++k) {
    radiance.add(k, glm::vec3(points.ggx.emitted[k]));
  }
  return pairs;
}

}  // namespace brume
