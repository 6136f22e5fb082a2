#pragma once

#include <glm/mat3x3.hpp>

#include "core/io/import/gltf_file.h"
#include "core/io/import/raw_scene.h"

namespace brume {

// Texture coordinates of a mesh as a texture uses them.
struct GltfTexcoords {
  std::size_t set = 0;        // TEXCOORD_n
  glm::dmat3 transform{1.0};  // of (u, v, 1) as the file has them, v down

  bool operator==(const GltfTexcoords&) const = default;
};

// A material of a glTF file, and the texture coordinates that its textures use: up to two, which
// its meshes have.
struct GltfMaterial {
  RawMaterial material;
  std::vector<GltfTexcoords> texcoords;
};

// The images of a glTF file that textures use; no others are looked at.
class GltfImages {
 public:
  explicit GltfImages(GltfFile& file) : file_(file), images_(file.list("images").size()) {}

  // Reads one; what cannot be has an `error`.
  void use(std::size_t index);
  // There are as many as the list `images` has; empty ones where none is used.
  [[nodiscard]] const std::vector<RawImage>& all() const { return images_; }

 private:
  GltfFile& file_;
  std::vector<RawImage> images_;
};

GltfMaterial read_gltf_material(GltfFile& file, GltfImages& images, std::size_t index);

}  // namespace brume
