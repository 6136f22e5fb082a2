#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>

namespace brume {

class Texture;

// Beyond its edges an image goes on from the other side, as its edge, or mirrored.
enum class TextureWrap { repeat, clamp, mirror };

// An image that a material looks up by texture coordinates: u to the right, v up, the image fills
// [0, 1] x [0, 1].
struct TextureReference {
  std::filesystem::path file;              // empty: none
  std::shared_ptr<const Texture> content;  // null: none, or its file is missing; as if white
  TextureWrap wrap_u = TextureWrap::repeat;
  TextureWrap wrap_v = TextureWrap::repeat;
  // Whether it is looked up by the mesh's second texture coordinates, if there are any.
  bool uses_second_texcoords = false;

  bool operator==(const TextureReference&) const = default;
};

// How much of a surface is there: all of it, all but its holes, or a share.
enum class AlphaMode { opaque, cutout, blend };

// The metallic-roughness material of glTF 2.0: reflection by GGX; evaluated by
// core/scene/materials/ggx.h. Each value is multiplied by what its texture holds, some
// by colors of the mesh's vertices.
struct MetallicRoughness {
  glm::dvec3 base_color{1.0};  // RGB in [0, 1]
  double metallic = 1.0;       // in [0, 1]
  double roughness = 1.0;      // in [0, 1]
  glm::dvec3 emissive{0.0};    // radiance, RGB, >= 0 [W/(sr u^2)]
  double normal_scale = 1.0;   // of the normal map's slopes, in [0, 1000]
  // `cutout`: opacity times the texture's alpha below alpha_cutoff is a hole; `blend`: that product
  // is the share that the surface covers, all else passes.
  AlphaMode alpha = AlphaMode::opaque;
  double opacity = 1.0;          // in [0, 1]
  double alpha_cutoff = 0.5;     // in [0, 1]
  glm::dvec3 transmission{0.0};  // share of light that crosses it, unbent; RGB in [0, 1]

  TextureReference base_color_texture;          // RGB, and alpha that multiplies opacity
  TextureReference metallic_roughness_texture;  // roughness in G, metallic in B
  TextureReference normal_texture;              // 2 RGB - 1: along u, along v, along the normal
  TextureReference emissive_texture;            // RGB
  TextureReference transmission_texture;        // RGB

  bool operator==(const MetallicRoughness&) const = default;
};

}  // namespace brume
