#include "render/shading/surface_shading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scene/materials/brdf.h"
#include "render/optical_depth/path_depths.h"
#include "render/shading/area_highlight.h"
#include "render/simd/area_kernels.h"
#include "render/simd/ggx_kernels.h"
#include "render/simd/reflection_kernels.h"
#include "render/slices/slice_kernels.h"

namespace brume {
namespace {

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
