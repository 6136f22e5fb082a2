#include "render/cpu/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/scene/brdf.h"
#include "render/cpu/path_depths.h"
#include "render/cpu/slice_kernels.h"
#include "render/tiles.h"

namespace brume {

namespace {

// One light at the points of a tile.
struct LightAtPoints {
  std::vector<double> depths;    // T(s, p) of the Gaussians, for every point
  std::vector<std::size_t> lit;  // the points that the light shines on

  std::vector<glm::dvec3> ends;
  std::vector<std::int32_t> none;
  PathBatch paths;
  std::vector<float> looked_up;
  std::vector<glm::dvec3> origins;  // of shadow rays

  std::uint64_t find_depths(const MediumIndex& medium, const SurfaceLight& light,
                            std::span<const SurfacePoint> points, Settings::Arithmetic arithmetic) {
    ends.clear();
    for (const SurfacePoint& point : points) ends.push_back(point.position);
    depths.resize(ends.size());
    none.assign(ends.size(), -1);
    if (!light.table) {
      return bundle_depths(medium, light.light.position, ends, none, arithmetic, depths);
    }
    paths.assign(light.light.position, ends, none);
    looked_up.resize(paths.padded_size());
    look_up_depths(*light.table, paths, looked_up.data());
    std::copy_n(looked_up.begin(), ends.size(), depths.begin());
    return 0;
  }

  void find_lit(const PointLight& light, const Visibility& visibility,
                std::span<const SurfacePoint> points) {
    lit.clear();
    origins.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!(glm::dot(points[k].normal, light.position - points[k].position) > 0.0)) continue;
      lit.push_back(k);
      origins.push_back(points[k].shadow_origin);
    }
    std::array<bool, Tiles::pixels> blocked;
    visibility.blocked(origins, light.position, std::span(blocked).first(origins.size()));
    std::size_t kept = 0;
    for (std::size_t k = 0; k < lit.size(); ++k) {
      if (!blocked[k]) lit[kept++] = lit[k];
    }
    lit.resize(kept);
  }
};

// Where a point light stands as seen from a point, and what comes of it.
struct Arrival {
  glm::dvec3 wi;      // unit
  double irradiance;  // without medium, straight on, per unit of intensity
  double depth;       // T(s, p)
};

Arrival arrival(const MediumIndex& medium, const PointLight& light, const SurfacePoint& point,
                double gaussians_depth) {
  const glm::dvec3 q = light.position - point.position;
  const double distance = glm::length(q);
  return {q / distance, 1.0 / (distance * distance),
          gaussians_depth + medium.homogeneous_density() * distance};
}

// The irradiance that light makes whose bands are those of a delta function times `factors`, the
// cosine being that between its direction and the normal: sh_convolve() with clamped_cosine_sh(),
// written out, where the bands 3 and 5 are 0.
float diffuse_irradiance(const ScatterTable::Bands& factors, float cosine) {
  const float x2 = cosine * cosine;
  const float p2 = 1.5f * x2 - 0.5f;
  const float p4 = (4.375f * x2 - 3.75f) * x2 + 0.375f;
  return std::max(0.0f, 0.25f * factors[0] + 0.5f * cosine * factors[1] +
                            0.3125f * p2 * factors[2] - 0.09375f * p4 * factors[4]);
}

// What the surface reflects of such light by any BRDF, RGB [1/sr].
glm::vec3 reflection(const BrdfSh& brdf, const ScatterTable::Bands& factors,
                     const SurfacePoint& point, const glm::dvec3& wi) {
  const ShVector<glm::dvec3> B = brdf(glm::dot(point.normal, point.to_eye));
  const glm::dquat frame = surface_frame(point.normal, point.to_eye);
  const ShVector<float> delta = sh_basis(B.order(), glm::vec3(glm::conjugate(frame) * wi));
  glm::vec3 sum(0.0f);
  for (int l = 0; l < B.order(); ++l) {
    // In that frame B is even in y: what is odd, m < 0, vanishes.
    glm::vec3 band(0.0f);
    for (int m = 0; m <= l; ++m) band += delta[sh_index(l, m)] * glm::vec3(B[sh_index(l, m)]);
    sum += factors[static_cast<std::size_t>(l)] * band;
  }
  return glm::max(sum, 0.0f);
}

// Point spread functions take the medium to be homogeneous. The glow close to a light is most of
// that of a point light, and it is not there where the light stands outside the medium: then its
// light is spread as distant light is. In between, the share of the depth counts that a medium as
// dense as at the light would make.
ScatterTable::Bands spread_of(const SurfaceLighting& lighting, double density, const Arrival& a) {
  const auto T = static_cast<float>(a.depth);
  ScatterTable::Bands factors = (*lighting.distant)(T);
  const ScatterTable::Bands near = (*lighting.point)(T);
  const double homogeneous = density / std::sqrt(a.irradiance);
  const auto share = static_cast<float>(homogeneous < a.depth ? homogeneous / a.depth : 1.0);
  for (std::size_t l = 0; l < near.size(); ++l) factors[l] += share * (near[l] - factors[l]);
  return factors;
}

// Per unit of intensity.
glm::vec3 scattered(const ScatterTable::Bands& factors, const SurfaceShading& shading,
                    const SurfacePoint& point, const Arrival& light) {
  const auto irradiance = static_cast<float>(light.irradiance);
  if (shading.brdf) return irradiance * reflection(*shading.brdf, factors, point, light.wi);
  const auto cosine = static_cast<float>(glm::dot(point.normal, light.wi));
  return glm::vec3(point.surface->material.reflectance * std::numbers::inv_pi) *
         (irradiance * diffuse_irradiance(factors, cosine));
}

glm::vec3 of_environment(const EnvironmentLight& environment, const SurfaceShading& shading,
                         const SurfacePoint& point, float Tbar, double albedo) {
  if (!shading.brdf) {
    return glm::vec3(point.surface->material.reflectance) *
           environment.diffuse(point.normal, Tbar, albedo);
  }
  const glm::dquat frame = surface_frame(point.normal, point.to_eye);
  const ShVector<glm::dvec3> light =
      sh_rotate(environment.incident(Tbar, albedo), glm::conjugate(frame));
  const ShVector<glm::dvec3> B = (*shading.brdf)(glm::dot(point.normal, point.to_eye));
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < B.size(); ++i) sum += light[i] * B[i];
  return glm::vec3(glm::max(sum, 0.0));
}

}  // namespace

std::uint64_t surface_radiance(const MediumIndex& medium, const Visibility& visibility,
                               const SurfaceLighting& lighting, std::span<const Surface> surfaces,
                               std::span<const SurfacePoint> points,
                               Settings::Arithmetic arithmetic, std::span<glm::vec3> radiance) {
  thread_local LightAtPoints at;
  std::fill(radiance.begin(), radiance.end(), glm::vec3(0.0f));
  const auto shading = [&](const SurfacePoint& point) -> const SurfaceShading& {
    return lighting.surfaces[static_cast<std::size_t>(point.surface - surfaces.data())];
  };
  std::uint64_t pairs = 0;
  for (const SurfaceLight& light : lighting.lights) {
    pairs += at.find_depths(medium, light, points, arithmetic);
    at.find_lit(light.light, visibility, points);
    for (const std::size_t k : at.lit) {
      const SurfacePoint& point = points[k];
      const Arrival a = arrival(medium, light.light, point, at.depths[k]);
      radiance[k] += glm::vec3(brdf(point.surface->material, a.wi, point.to_eye, point.normal) *
                               light.light.intensity *
                               (glm::dot(point.normal, a.wi) * std::exp(-a.depth) * a.irradiance));
    }
    if (!lighting.point) continue;
    const glm::vec3 intensity(lighting.albedo * light.light.intensity);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Arrival a = arrival(medium, light.light, points[k], at.depths[k]);
      if (!std::isfinite(a.irradiance)) continue;  // the light stands on the surface
      radiance[k] += intensity * scattered(spread_of(lighting, light.density, a),
                                           shading(points[k]), points[k], a);
    }
  }
  if (lighting.environment) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const SurfaceShading& own = shading(points[k]);
      const auto fog = static_cast<float>(lighting.fog_depth);
      const float Tbar = own.average_depth ? fog + (*own.average_depth)(points[k].position) : fog;
      radiance[k] += of_environment(*lighting.environment, own, points[k], Tbar, lighting.albedo);
    }
  }
  return pairs;
}

}  // namespace brume
