#pragma once

#include <vector>

#include "render/geometry/medium_index.h"
#include "render/lighting/environment_light.h"
#include "render/lighting/optical_depth_table.h"
#include "render/lighting/source_lookup.h"
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
  PointLight light;
  double density = 0.0;                      // b(s) of the medium [1/u]
  const OpticalDepthTable* table = nullptr;  // source of T(s, p); null: exact sum
};

struct SurfaceLighting {
  std::vector<SurfaceLight> lights;
  // For lights inside the medium and for distant light; null: no scattering medium. See
  // spread_of().
  const ScatterTable* point = nullptr;
  const ScatterTable* distant = nullptr;
  const EnvironmentLight* environment = nullptr;  // null: none
  // Grid of incident environment light, with receivers. Null: average optical depth is used.
  const SourceGrid* incident = nullptr;
  double fog_depth = 0.0;  // average optical depth of b0
  double albedo = 1.0;
};

// Calls visit(k, incident environment light at point k, in the form that EnvironmentLight takes).
template <class Visit>
void for_each_incident(const SurfaceLighting& lighting, const AverageDepthGrid* average_depth,
                       const SurfacePoints& points, Visit visit) {
  if (lighting.incident) {
    const SourceLookup light(*lighting.incident, points.origin);
    for (std::size_t k = 0; k < points.count; ++k) {
      visit(k, light.incident(glm::vec3(points.position[k])));
    }
    return;
  }
  const auto fog = static_cast<float>(lighting.fog_depth);
  for (std::size_t k = 0; k < points.count; ++k) {
    const float Tbar =
        average_depth ? fog + (*average_depth)(points.origin + points.position[k]) : fog;
    visit(k, lighting.environment->incident(Tbar, lighting.albedo));
  }
}

// Shading parameters of a light for an analytic material.
PointLightShading point_light_shading(const Material& material, const PointLight& light);

// Sets at.depths from at.paths. Returns the Gaussian x path pairs evaluated. Thread-safe.
std::uint64_t find_depths(const MediumIndex& medium, const SurfaceLight& light,
                          const SurfacePoints& points, Settings::Precision precision,
                          LightAtPoints& at);

// Outgoing RGB radiance at points of one surface:
//   direct light with cast shadows, times exp(-T(s, p)) and brdf();
//   light of point lights scattered once by the medium (eq. 25), unshadowed;
//   environment light, direct and scattered, unshadowed: from the grid, or with the average optical
//   depth (eq. 27);
// the last two as spherical harmonics of six bands. Single precision except T(s, p), which depends
// on `precision` unless there is a table. Returns the Gaussian x path pairs evaluated.
// Thread-safe.
std::uint64_t surface_radiance(const MediumIndex& medium, const RayCaster& ray_caster,
                               const SurfaceLighting& lighting, const SurfaceShading& shading,
                               const SurfacePoints& points, Settings::Precision precision,
                               PointRadiance& radiance);

}  // namespace brume
