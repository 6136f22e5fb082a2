#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "brume/scene.h"
#include "core/scene/materials/ggx.h"

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
};

// brdf() of the material at the point, for light from wi that is reflected to the eye [1/sr].
glm::dvec3 brdf(const SurfacePoint& point, const glm::dvec3& wi);

// How a texture lies on a triangle, at one of its points.
struct TextureFrame {
  glm::dvec2 uv{0.0};
  glm::dvec3 along_u{0.0};  // the point's derivatives, of any length, 0 where there is no texture
  glm::dvec3 along_v{0.0};
  double density = 0.0;  // side of a square in the texture per side in the world [1/u]

  TextureFrame() = default;
  // `weights` are barycentric.
  TextureFrame(const std::array<glm::dvec3, 3>& positions,
               const std::array<glm::dvec2, 3>& texcoords, const glm::dvec3& weights);

  // A normal of the texture's frame, turned to that around the unit normal n of the surface's
  // front.
  [[nodiscard]] glm::dvec3 to_world(const glm::dvec3& of_texture, const glm::dvec3& n) const;
};

// The material at a point; turns its unit normal, which is on the visible side, by the normal map.
// `side`: 1 if that is the mesh's front, else -1; `width`: of what is averaged [u].
MaterialPoint material_at(const MetallicRoughness& material, const TextureFrame& frame,
                          double width, double side, glm::dvec3& normal);

}  // namespace brume
