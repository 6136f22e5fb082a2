#pragma once

#include <vector>

#include "render/cpu/light_table.h"
#include "render/cpu/scatter_table.h"
#include "render/cpu/source_look_up.h"
#include "render/cpu/surface_kernels.h"
#include "render/cpu/surface_points.h"
#include "render/cpu/visibility.h"
#include "render/environment_light.h"
#include "render/medium_index.h"
#include "render/prepared_shading.h"
#include "render/settings.h"

namespace brume {

// The light that surfaces send to the eye (section 4 of the paper). What the medium takes between
// surface and eye is left to the compositing (eq. 29).

struct SurfaceLight {
  PointLight light;
  double density = 0.0;                // b(s) of the medium [1/u]
  const LightTable* table = nullptr;   // where T(s, p) is taken from; null: it is summed exactly
};

struct SurfaceLighting {
  std::vector<SurfaceLight> lights;
  // Of light that starts in the medium and of light that comes from outside; null: no medium
  // scatters. See spread_of().
  const ScatterTable* point = nullptr;
  const ScatterTable* distant = nullptr;
  const EnvironmentLight* environment = nullptr;  // null: there is none
  // With receivers: what arrives of the environment. Null: it has the average optical depth.
  const SourceGrid* arriving = nullptr;
  double fog_depth = 0.0;  // b0's part of the average optical depth
  double albedo = 1.0;
};

// Calls visit(k, what arrives of the environment at point k, as EnvironmentLight takes it).
template <class Visit>
void each_arrival(const SurfaceLighting& lighting, const AverageDepthGrid* average_depth,
                  const SurfacePoints& points, Visit visit) {
  if (lighting.arriving) {
    const SourceLookUp light(*lighting.arriving, points.origin);
    for (std::size_t k = 0; k < points.count; ++k) {
      visit(k, light.arriving(glm::vec3(points.position[k])));
    }
    return;
  }
  const auto fog = static_cast<float>(lighting.fog_depth);
  for (std::size_t k = 0; k < points.count; ++k) {
    const float Tbar =
        average_depth ? fog + (*average_depth)(points.origin + points.position[k]) : fog;
    visit(k, lighting.environment->arriving(Tbar, lighting.albedo));
  }
}

// What a material that is not measured makes of a light.
PointLightShading point_light_shading(const Material& material, const PointLight& light);

// Sets at.depths of points for a light whose at.paths are set. Returns the number of Gaussian x
// path pairs evaluated. Thread-safe.
std::uint64_t find_depths(const MediumIndex& medium, const SurfaceLight& light,
                          const SurfacePoints& points, Settings::Arithmetic arithmetic,
                          LightAtPoints& at);

// Sets the RGB radiance of points of one surface, which `shading` belongs to:
//   light that comes straight from the lights, with cast shadows, times exp(-T(s, p)), by brdf();
//   light of theirs that the medium scatters once on its way (eq. 25), which no surface shadows;
//   light of the environment, straight and scattered, which no surface shadows: as the grid has it,
//   or with the average optical depth (eq. 27);
// the last two as spherical harmonics of six bands. In single precision but for T(s, p), which
// `arithmetic` decides on where there is no table. Returns the number of Gaussian x path pairs
// evaluated. Thread-safe.
std::uint64_t surface_radiance(const MediumIndex& medium, const Visibility& visibility,
                               const SurfaceLighting& lighting, const SurfaceShading& shading,
                               const SurfacePoints& points, Settings::Arithmetic arithmetic,
                               PointRadiance& radiance);

}  // namespace brume
