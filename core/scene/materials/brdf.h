#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "brume/scene.h"
#include "brume/surface.h"
#include "core/math/spherical_harmonics.h"

namespace brume {

// How a material reflects light that comes from the unit direction wi towards the unit direction
// wo, at the unit normal n [1/sr]; all three leave the surface. 0 for light from behind. wo may be
// a little behind the surface, as interpolated normals have it.
//   diffuse    reflectance / pi
//   phong      reflectance / pi + specular (e + 2) / (2 pi) max(0, r.wo)^e, r being wi mirrored at
//              n: the specular part reflects `specular` at normal incidence, and less at others
//              (Lafortune and Willems 1994)
//   measured   MeasuredBrdf
//   metallic_roughness   ggx_brdf(), with the averages of its textures
glm::dvec3 brdf(const Material& material, const glm::dvec3& wi, const glm::dvec3& wo,
                const glm::dvec3& n);

// Shading frame: rotates +z to the normal, and +x to the side of wo.
glm::dquat surface_frame(const glm::dvec3& n, const glm::dvec3& wo);

// f(wi, wo) max(0, cos theta_i) as spherical harmonics of wi in surface_frame(), for every polar
// angle of wo: B of eq. 23. The outgoing radiance under light L in the same frame is sh_dot(L, B).
class BrdfSh {
 public:
  // About 10 ms unless diffuse.
  BrdfSh(const Material& material, int order);

  // cos_theta_o in [-1, 1], clamped to >= 0. Linear between rows 1.4 degrees apart.
  [[nodiscard]] ShVector<glm::dvec3> operator()(double cos_theta_o) const;

 private:
  std::vector<ShVector<glm::dvec3>> rows_;  // polar angles 0 to pi/2; one row if diffuse
};

// Zonal coefficients of max(0, cos theta): convolution with them gives irradiance.
ZonalSh<double> clamped_cosine_sh();

// Per band, the factor of a convolution with max(0, cos theta) / pi.
const ZonalSh<float>& clamped_cosine_factors();

// The part of light that a material reflects, RGB in [0, 1], of light that comes evenly from all
// directions: its directional albedo, averaged over a cosine. Highlights of every width are
// integrated over half vectors; textures count by their averages. `color`: of
// vertices, see MeshArrays.
glm::dvec3 mean_reflectance(const Material& material, const glm::dvec4& color = glm::dvec4(1.0));

}  // namespace brume
