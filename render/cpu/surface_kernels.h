#pragma once

#include <array>
#include <glm/ext/vector_int2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/scene/camera.h"
#include "render/cpu/scatter_table.h"
#include "render/cpu/surface_points.h"

namespace brume {

// The inner loops of surfaces in single precision (Highway). Plain double counterparts, for single
// points: Visibility::point(), brdf(), incident_point_light().

// The unit directions of the view rays through pixels of a film, as many as a tile has at most;
// those from their count to padded(count) repeat the last. The plain double counterpart is
// CameraRays::direction().
void find_view_directions(const CameraRays& rays, std::span<const glm::ivec2> pixels,
                          PointVectors& directions);

// The corners of the triangles that points are on.
struct PointTriangles {
  std::array<PointVectors, 3> position;
  std::array<PointVectors, 3> normal;  // any length
};

// Sets position, normal, shadow_origin and side of points.padded_size() points from triangles, `u`,
// `v` and `to_eye`; `offset` [u] is how far shadow rays start off the triangle.
void interpolate_points(const PointTriangles& triangles, float offset, SurfacePoints& points);

// Sets all but depths and lit of a light at `position` relative to points.origin.
void see_light(const SurfacePoints& points, const glm::vec3& position, LightAtPoints& light);

// What a point light brings to points, RGB.
struct PointLightShading {
  glm::vec3 intensity{0.0f};  // [W/sr]
  // The material: reflectance / pi, and specular (e + 2) / (2 pi), see brdf().
  glm::vec3 diffuse{0.0f};
  glm::vec3 highlight{0.0f};
  float exponent = 1.0f;
};

// radiance += what comes straight from the light, where it is lit, times e^-T.
void add_direct_light(const SurfacePoints& points, const LightAtPoints& light,
                      const PointLightShading& shading, PointRadiance& radiance);

// Point spread functions take the medium to be homogeneous. The glow close to a light is most of
// that of a point light, and it is not there where the light stands outside the medium: then its
// light is spread as distant light is. In between, the share of the depth counts that a medium as
// dense as at the light would make.
struct LightSpread {
  const ScatterTable* point = nullptr;
  const ScatterTable* distant = nullptr;
  float density = 0.0f;  // b(s) [1/u]
};

// factors[l] = how much of the light in band l the medium scatters onto the points, per unit of
// irradiance without medium; bands that a diffuse surface does not see (3 and 5) are left out
// where `diffuse_only`.
void find_spread(const LightAtPoints& light, std::size_t padded_size, const LightSpread& spread,
                 bool diffuse_only, std::array<PointArray, sh_most_bands>& factors);

// radiance += what a diffuse surface, shading.diffuse, reflects of the light in those bands.
void add_scattered_light(const SurfacePoints& points, const LightAtPoints& light,
                         const std::array<PointArray, sh_most_bands>& factors,
                         const PointLightShading& shading, PointRadiance& radiance);

}  // namespace brume
