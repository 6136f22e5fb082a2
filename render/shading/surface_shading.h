#pragma once

#include <array>
#include <vector>

#include "render/geometry/medium_index.h"
#include "render/geometry/point_source.h"
#include "render/optical_depth/optical_depth_table.h"
#include "render/scattering/environment_light.h"
#include "render/scattering/incident_lookup.h"
#include "render/settings.h"
#include "render/shading/prepared_shading.h"
#include "render/simd/scatter_table.h"
#include "render/simd/surface_kernels.h"
#include "render/simd/surface_points.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Outgoing radiance of surfaces towards the eye (section 4 of the paper). Attenuation between
// surface and eye is part of compositing (eq. 29).

struct SurfaceLight {
  PointSource source;
  double density = 0.0;                      // b(s) of the medium, 0 of far lights [1/u]
  const OpticalDepthTable* table = nullptr;  // source of T(s, p); null: exact sum
};

struct SurfaceLighting {
  std::vector<SurfaceLight> lights;
  // For lights inside the medium and for distant light; null: no scattering medium. See
  // spread_of().
  const ScatterTable* point = nullptr;
  const ScatterTable* distant = nullptr;
  const EnvironmentLight* environment = nullptr;  // null: none
  // Grid of incident light, with receivers, in units of 1 / incident_scale. Null: average optical
  // depth is used.
  const SourceGrid* incident = nullptr;
  double incident_scale = 1.0;
  // The grid holds all light but the point lights' unscattered: of all orders, and kept out by
  // surfaces. `point` is null then, and optical depths of lights are times `extinction`.
  bool incident_is_all = false;
  double extinction = 1.0;
  NodeVisibility visibility{};  // of the eye
  double fog_depth = 0.0;       // average optical depth of b0 where it is the same everywhere
  FogBall fog{};                // else of that density in a ball
  double fog_density = 0.0;     // [1/u]
  double albedo = 1.0;

  // Average optical depth of fog around x.
  [[nodiscard]] double fog_depth_at(const glm::dvec3& x) const {
    return fog.is_endless() ? fog_depth : fog_density * fog.mean_length(x);
  }

  [[nodiscard]] bool has_indirect() const { return environment || incident; }
};

// Incident light at a point as for_each_incident() gives it.
inline ShVector<glm::dvec3> incident_light(const SurfaceLighting& lighting,
                                           const NodeRadiance& light) {
  return incident_light(light, lighting.incident_scale, lighting.environment);
}
inline ShVector<glm::dvec3> incident_light(const SurfaceLighting& lighting,
                                           const ScatterTable::Bands& fractions) {
  return lighting.environment->incident(fractions);
}

// With a grid.
inline IncidentLookup incident_lookup(const SurfaceLighting& lighting,
                                      const SurfacePoints& points) {
  return {*lighting.incident, points.origin, lighting.visibility};
}

// Calls visit(k, fractions of the environment at point k), without a grid.
template <class Visit>
void for_each_fraction(const SurfaceLighting& lighting, const AverageDepthGrid* average_depth,
                       const SurfacePoints& points, Visit visit) {
  for (std::size_t k = 0; k < points.count; ++k) {
    const glm::dvec3 x = points.origin + points.position[k];
    const auto fog = static_cast<float>(lighting.fog_depth_at(x));
    const float Tbar = average_depth ? fog + (*average_depth)(x) : fog;
    visit(k, lighting.environment->incident(Tbar, lighting.albedo));
  }
}

// Calls visit(k, incident light at point k).
template <class Visit>
void for_each_incident(const SurfaceLighting& lighting, const AverageDepthGrid* average_depth,
                       const SurfacePoints& points, Visit visit) {
  if (!lighting.incident) {
    for_each_fraction(lighting, average_depth, points, visit);
    return;
  }
  thread_local std::array<NodeRadiance, Tiles::pixels> light;
  incident_lookup(lighting, points).incident(points, light);
  for (std::size_t k = 0; k < points.count; ++k) visit(k, light[k]);
}

// Shading parameters of a light for an analytic material.
PointLightShading point_light_shading(const Material& material, const PointSource& light);

// Sets at.depths from at.paths, times `extinction`. Returns the Gaussian x path pairs evaluated.
// Thread-safe.
std::uint64_t find_depths(const MediumIndex& medium, const SurfaceLight& light,
                          const SurfacePoints& points, Settings::Precision precision,
                          double extinction, LightAtPoints& at);

// Outgoing RGB radiance at points of one surface:
//   direct light with cast shadows, times exp(-T(s, p)) and brdf();
//   light of point lights scattered once by the medium (eq. 25), unshadowed;
//   environment light, direct and scattered, unshadowed: from the grid, or with the average optical
//   depth (eq. 27); or in place of both, light of all orders from the grid, shadowed;
// the last two as spherical harmonics of six bands. Single precision except T(s, p), which depends
// on `precision` unless there is a table. Returns the Gaussian x path pairs evaluated.
// Thread-safe.
std::uint64_t surface_radiance(const MediumIndex& medium, const RayCaster& ray_caster,
                               const SurfaceLighting& lighting, const SurfaceShading& shading,
                               const SurfacePoints& points, Settings::Precision precision,
                               PointRadiance& radiance);

}  // namespace brume
