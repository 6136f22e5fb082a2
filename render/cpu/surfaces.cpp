#include "render/cpu/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <numbers>

#include "core/scene/brdf.h"
#include "render/cpu/path_depths.h"
#include "render/cpu/slice_kernels.h"
#include "render/cpu/surface_kernels.h"

namespace brume {
namespace {

using BandArrays = std::array<PointArray, sh_most_bands>;

PointLightShading shading_of(const Material& material, const PointLight& light) {
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

void add(const glm::vec3& value, std::size_t k, PointRadiance& radiance) {
  radiance.r[k] += value.r;
  radiance.g[k] += value.g;
  radiance.b[k] += value.b;
}

// What brdf() has no kernel for, point by point.
void add_measured_light(const SurfacePoints& points, const LightAtPoints& at,
                        const glm::vec3& intensity, PointRadiance& radiance) {
  for (std::size_t k = 0; k < points.count; ++k) {
    if (!(at.cosine[k] > 0.0f && at.lit[k] > 0.0f)) continue;
    const glm::dvec3 wi(-at.paths.x[k], -at.paths.y[k], -at.paths.z[k]);
    const glm::vec3 f(brdf(points.surface->material, wi, points.to_eye[k], points.normal[k]));
    const float arrives = at.cosine[k] * at.inverse_square[k] * std::exp(-at.depths[k]);
    add(f * intensity * arrives, k, radiance);
  }
}

// What a surface of any BRDF reflects of light from wi in the bands' shares, RGB [1/sr].
glm::vec3 reflection(const BrdfSh& brdf, const BandArrays& factors, std::size_t k,
                     const glm::dvec3& normal, const glm::dvec3& to_eye, const glm::dvec3& wi) {
  const ShVector<glm::dvec3> B = brdf(glm::dot(normal, to_eye));
  const glm::dquat frame = surface_frame(normal, to_eye);
  const ShVector<float> delta = sh_basis(B.order(), glm::vec3(glm::conjugate(frame) * wi));
  glm::vec3 sum(0.0f);
  for (int l = 0; l < B.order(); ++l) {
    // In that frame B is even in y: what is odd, m < 0, vanishes.
    glm::vec3 band(0.0f);
    for (int m = 0; m <= l; ++m) band += delta[sh_index(l, m)] * glm::vec3(B[sh_index(l, m)]);
    sum += factors[static_cast<std::size_t>(l)][k] * band;
  }
  return glm::max(sum, 0.0f);
}

void add_reflections(const BrdfSh& brdf, const BandArrays& factors, const SurfacePoints& points,
                     const LightAtPoints& at, const glm::vec3& intensity, PointRadiance& radiance) {
  for (std::size_t k = 0; k < points.count; ++k) {
    const glm::dvec3 wi(-at.paths.x[k], -at.paths.y[k], -at.paths.z[k]);
    add(intensity * (at.inverse_square[k] *
                     reflection(brdf, factors, k, points.normal[k], points.to_eye[k], wi)),
        k, radiance);
  }
}

// `arriving` is what EnvironmentLight takes.
template <class Arriving>
glm::vec3 of_environment(const EnvironmentLight& environment, const Arriving& arriving,
                         const BrdfSh* brdf, const SurfacePoints& points, std::size_t k) {
  const glm::dvec3 normal = points.normal[k];
  if (!brdf) {
    return glm::vec3(points.surface->material.reflectance) * environment.diffuse(normal, arriving);
  }
  const glm::dquat frame = surface_frame(normal, points.to_eye[k]);
  const ShVector<glm::dvec3> light =
      sh_rotate(environment.incident(arriving), glm::conjugate(frame));
  const ShVector<glm::dvec3> B = (*brdf)(glm::dot(normal, points.to_eye[k]));
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < B.size(); ++i) sum += light[i] * B[i];
  return glm::vec3(glm::max(sum, 0.0));
}

void add_environment(const SurfaceLighting& lighting, const SurfaceShading& shading,
                     const SurfacePoints& points, PointRadiance& radiance) {
  each_arrival(lighting, shading.average_depth, points, [&](std::size_t k, const auto& arriving) {
    add(of_environment(*lighting.environment, arriving, shading.brdf, points, k), k, radiance);
  });
}

}  // namespace

std::uint64_t find_depths(const MediumIndex& medium, const SurfaceLight& light,
                          const SurfacePoints& points, Settings::Arithmetic arithmetic,
                          LightAtPoints& at) {
  std::uint64_t pairs = 0;
  if (light.table) {
    look_up_depths(*light.table, at.paths, at.depths.data());
  } else {
    std::array<glm::dvec3, Tiles::pixels> ends;
    std::array<double, Tiles::pixels> depths;
    std::array<std::int32_t, Tiles::pixels> none;
    none.fill(-1);
    for (std::size_t k = 0; k < points.count; ++k) ends[k] = points.origin + points.position[k];
    pairs = bundle_depths(medium, light.light.position, std::span(ends).first(points.count),
                          std::span(none).first(points.count), arithmetic,
                          std::span(depths).first(points.count));
    for (std::size_t k = 0; k < points.padded_size(); ++k) {
      at.depths[k] = static_cast<float>(depths[std::min(k, points.count - 1)]);
    }
  }
  const auto b0 = static_cast<float>(medium.homogeneous_density());
  for (std::size_t k = 0; b0 > 0.0f && k < points.padded_size(); ++k) {
    at.depths[k] += b0 * at.paths.length[k];
  }
  return pairs;
}

std::uint64_t surface_radiance(const MediumIndex& medium, const Visibility& visibility,
                               const SurfaceLighting& lighting, const SurfaceShading& shading,
                               const SurfacePoints& points, Settings::Arithmetic arithmetic,
                               PointRadiance& radiance) {
  thread_local LightAtPoints at;
  thread_local BandArrays factors;
  for (PointArray* channel : {&radiance.r, &radiance.g, &radiance.b}) channel->fill(0.0f);
  const Material& material = points.surface->material;
  std::uint64_t pairs = 0;
  for (const SurfaceLight& light : lighting.lights) {
    const glm::vec3 position(light.light.position - points.origin);
    see_light(points, position, at);
    pairs += find_depths(medium, light, points, arithmetic, at);
    visibility.find_lit(points, position, at);
    PointLightShading reflected = shading_of(material, light.light);
    if (material.type == Material::Type::measured) {
      add_measured_light(points, at, reflected.intensity, radiance);
    } else {
      add_direct_light(points, at, reflected, radiance);
    }
    if (!lighting.point) continue;
    find_spread(at, points.padded_size(),
                {lighting.point, lighting.distant, static_cast<float>(light.density)},
                !shading.brdf, factors);
    reflected.intensity *= static_cast<float>(lighting.albedo);
    if (shading.brdf) {
      add_reflections(*shading.brdf, factors, points, at, reflected.intensity, radiance);
    } else {
      add_scattered_light(points, at, factors, reflected, radiance);
    }
  }
  if (lighting.environment) add_environment(lighting, shading, points, radiance);
  return pairs;
}

}  // namespace brume
