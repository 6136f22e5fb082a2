#pragma once

#include <glm/mat3x3.hpp>
#include <optional>

#include "core/io/import/gltf_file.h"
#include "core/io/import/raw_scene.h"

namespace brume {

// A material of a glTF file, and the texture coordinates of its textures.
struct GltfMaterial {
  RawMaterial material;
  std::size_t texcoord_set = 0;      // TEXCOORD_n
  glm::dmat3 texcoord_transform{1.0};  // of (u, v, 1) as the file has them, v down
};

GltfMaterial read_gltf_material(GltfFile& file, const Json& value, const JsonPath& path);

// The image of each element of the list `images`.
std::vector<RawImage> read_gltf_images(GltfFile& file);

}  // namespace brume
