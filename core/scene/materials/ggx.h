#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "brume/scene.h"
#include "core/scene/materials/mesh_values.h"

namespace brume {

// Reflection of metallic-roughness materials, as appendix B of the glTF 2.0 specification combines
// it: with H between light and eye, s = (1 - V.H)^5,
//   f = diffuse / pi (1 - s) + (f0 (1 - s) + s) D(H) V(L, V)
//   f0      = mix(0.04, base_color, metallic)
//   diffuse = (1 - metallic) base_color (1 - f0): what the specular part does not reflect, whose
//             Fresnel term is Schlick's, f0 + (1 - f0) s
//   D       = Trowbridge-Reitz with alpha = roughness^2
//   V       = G / (4 N.L N.V), G of Smith, heights of light and eye correlated (Heitz 2014; the
//             specification's is not, and darker)
// Light that a material transmits is taken from `diffuse`. Light that is scattered between
// microfacets more than once is lost: at roughness 1 up to half of it.
struct GgxReflection {
  glm::dvec3 diffuse{0.0};
  glm::dvec3 f0{0.0};
  double alpha = 1.0;

  // Smoother surfaces are taken for this one: a point light's highlight on a mirror is of no size.
  static constexpr double min_alpha = 1e-3;
  // Those below this show what is around them; rougher ones reflect no more of it than spherical
  // harmonics hold.
  static constexpr double max_mirror_alpha = 0.25;
  // Materials that are no metal have an index of refraction of 1.5.
  static constexpr double dielectric_f0 = 0.04;

  GgxReflection() = default;
  GgxReflection(const glm::dvec3& base_color, double metallic, double roughness);
};

// Cosines are clamped to this where the eye or the light is behind the normal.
inline constexpr double min_ggx_cosine = 1e-4;

double ggx_distribution(double alpha, double cos_h);                    // D [1/sr]
double ggx_visibility(double alpha, double cos_light, double cos_eye);  // V [1/sr]

// Directions as of brdf().
glm::dvec3 ggx_brdf(const GgxReflection& reflection, const glm::dvec3& wi, const glm::dvec3& wo,
                    const glm::dvec3& n);

// Draws wi in proportion to D(H) G1(V) max(0, V.H), the normals that the eye sees (Heitz 2018),
// from two numbers in [0, 1); and the density of that [1/sr].
glm::dvec3 sample_ggx(double alpha, const glm::dvec3& wo, const glm::dvec3& n, const glm::dvec2& u);
double ggx_pdf(double alpha, const glm::dvec3& wi, const glm::dvec3& wo, const glm::dvec3& n);

// Normals of normal maps are at least so high: others are none of a height field.
inline constexpr double min_normal_height = 1e-3;

// A metallic-roughness material at a point.
struct MaterialPoint {
  GgxReflection reflection;
  glm::dvec3 emitted{0.0};           // radiance [W/(sr u^2)]
  glm::dvec3 normal{0.0, 0.0, 1.0};  // unit: along u, along v, along the surface's normal
};

// Whether it is not the same everywhere: its material has textures or its mesh colors.
bool is_varied(const Surface& surface);

// Whether any point of it may be below GgxReflection::max_mirror_alpha.
bool may_mirror(const MetallicRoughness& material);

MaterialPoint material_at(const MetallicRoughness& material, const MeshValues& mesh);
// The same on average over its textures, without the normal map, where vertices have a color.
MaterialPoint average_material(const MetallicRoughness& material,
                               const glm::dvec4& color = glm::dvec4(1.0));

}  // namespace brume
