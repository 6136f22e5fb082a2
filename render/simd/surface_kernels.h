#pragma once

#include <array>
#include <glm/ext/vector_int2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/scene/camera_rays.h"
#include "core/scene/lights/point_lights.h"
#include "render/simd/scatter_table.h"
#include "render/simd/surface_points.h"

namespace brume {

// SIMD kernels of surfaces (Highway, single precision). Scalar double counterparts:
// Visibility::point(), brdf(), incident_point_light().

// Unit directions of the view rays through pixels, at most a tile's; padded to padded(count) by
// repeating the last. Scalar counterpart: CameraRays::direction().
void find_view_directions(const CameraRays& rays, std::span<const glm::ivec2> pixels,
                          PointVectors& directions);

// Corners of the triangles that points lie on.
struct PointTriangles {
  std::array<PointVectors, 3> position;
  std::array<PointVectors, 3> normal;  // any length
};

// Moves the positions of points.padded_size() points onto their triangles; sets normal,
// shadow_origin and side from those, `u`, `v` and `to_eye`.
void interpolate_points(const PointTriangles& triangles, SurfacePoints& points);

// Sets all members of `light` but depths and lit.
void point_to_light(const SurfacePoints& points, const PointLight& source, LightAtPoints& light);

// Shading parameters of a point light, RGB.
struct PointLightShading {
  glm::vec3 intensity{0.0f};  // [W/sr]
  // The material: reflectance / pi, and specular (e + 2) / (2 pi), see brdf().
  glm::vec3 diffuse{0.0f};
  glm::vec3 highlight{0.0f};
  float exponent = 1.0f;
};

// radiance += direct light where lit, times e^-T.
void add_direct_light(const SurfacePoints& points, const LightAtPoints& light,
                      const PointLightShading& shading, PointRadiance& radiance);

// Point spread functions assume a homogeneous medium. For a point light most scattered light comes
// from close to the light, which is missing if the light is outside the medium; it is then treated
// as distant light. In between, blended by the fraction of optical depth that a medium as dense as
// at the light would have.
struct LightSpread {
  const ScatterTable* point = nullptr;
  const ScatterTable* distant = nullptr;
  float density = 0.0f;  // b(s) [1/u]
};

// factors[l] = light of band l scattered onto the points, per unit of irradiance without medium.
// With `diffuse_only`, bands that do not affect diffuse surfaces (3 and 5) are skipped.
void find_spread(const LightAtPoints& light, std::size_t padded_size, const LightSpread& spread,
                 bool diffuse_only, std::array<PointArray, sh_max_bands>& factors);

// radiance += diffuse reflection (shading.diffuse) of the light in those bands.
void add_scattered_light(const SurfacePoints& points, const LightAtPoints& light,
                         const std::array<PointArray, sh_max_bands>& factors,
                         const PointLightShading& shading, PointRadiance& radiance);

}  // namespace brume
