#pragma once

#include <span>
#include <string>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/io/import/gltf_file.h"
#include "core/io/import/gltf_materials.h"

namespace brume {

// The vectors of an attribute; empty if missing.
template <class Vector>
std::vector<Vector> gltf_vectors(GltfFile& file, JsonObject& attributes, const std::string& key) {
  const auto accessor = file.index(attributes, key, "accessors");
  if (!accessor) return {};
  constexpr auto size = static_cast<std::size_t>(Vector::length());
  const std::vector<float> numbers = file.numbers(attributes.path_of(key), *accessor, size);
  std::vector<Vector> result(numbers.size() / size);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    result[i / size][static_cast<int>(i % size)] = numbers[i];
  }
  return result;
}

// The mesh of a primitive of triangles (`mode` 4), a strip (5) or a fan (6) in its own coordinates,
// without normals if it has none, with the texture coordinates that its material uses. `weights` of
// its morph targets, from the first on; those of others are 0.
MeshArrays read_gltf_mesh(GltfFile& file, JsonObject& primitive, std::int64_t mode,
                          std::span<const GltfTexcoords> texcoords,
                          std::span<const double> weights);

// The member `weights` of a node or a mesh; empty if missing.
std::vector<double> gltf_weights(GltfFile& file, JsonObject& object);

}  // namespace brume
