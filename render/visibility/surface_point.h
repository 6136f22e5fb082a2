#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

#include "brume/scene.h"
#include "core/scene/materials/ggx.h"
#include "core/scene/materials/mesh_values.h"
#include "render/simd/surface_points.h"

namespace brume {

// A hit point with everything shading needs.
struct SurfacePoint {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  // unit, interpolated, on the visible side; turned by a normal map
  glm::dvec3 to_eye{0.0};  // unit
  // Origin of shadow rays: offset from the triangle by a few float roundings, and onto the smooth
  // surface implied by the normals, so coarse triangles do not self-shadow (Hanika, "Hacking the
  // Shadow Terminator", Ray Tracing Gems II, 2021).
  glm::dvec3 shadow_origin{0.0};
  const Surface* surface = nullptr;
  // The reflection of a metallic-roughness material there.
  std::optional<GgxReflection> ggx{};
  glm::dvec3 emitted{0.0};  // radiance
  glm::dvec4 color{1.0};    // of its mesh there, see MeshArrays
};

// brdf() of the material at the point, for light from wi that is reflected to the eye [1/sr].
glm::dvec3 brdf(const SurfacePoint& point, const glm::dvec3& wi);

// How a texture lies on a triangle.
struct TextureFrame {
  glm::dvec3 along_u{0.0};  // a point's derivatives, of any length, 0 where there is no texture
  glm::dvec3 along_v{0.0};
  double density = 0.0;  // side of a square in the texture per side in the world [1/u]

  TextureFrame() = default;
  TextureFrame(const std::array<glm::dvec3, 3>& positions,
               const std::array<glm::dvec2, 3>& texcoords);

  // A normal of the texture's frame, turned to that around the unit normal n of the surface's
  // front.
  [[nodiscard]] glm::dvec3 to_world(const glm::dvec3& of_texture, const glm::dvec3& n) const;
};

// The values of a mesh at a point, and how textures lie there by each set of its texture
// coordinates.
struct MeshFrame {
  MeshValues values;  // without footprints
  std::array<TextureFrame, 2> textures;

  // The values with the footprints of a square of a side in the world [u].
  [[nodiscard]] MeshValues with_width(double width) const;
};

// The material at a point; turns its unit normal, which is on the visible side, by the normal map.
// `side`: 1 if that is the mesh's front, else -1; `width`: of what is averaged [u].
MaterialPoint material_at(const MetallicRoughness& material, const MeshFrame& frame, double width,
                          double side, glm::dvec3& normal);

// A pixel's cone at a grazing angle is taken to be no longer than at this one.
inline constexpr double min_grazing_cosine = 0.02;

// Sets points.ggx and turns normals by normal maps. `frames` of the points, if is_varied();
// `distances` from the eye [u].
void find_materials(std::span<const MeshFrame> frames, std::span<const double> distances,
                    SurfacePoints& points);

}  // namespace brume
