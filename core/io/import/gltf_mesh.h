#pragma once

#include <span>
#include <string>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/io/import/gltf_file.h"
#include "core/io/import/gltf_materials.h"
#include "core/io/import/node_motion.h"
#include "core/scene/deformation.h"

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

// Throws InputError unless an attribute has one value for each vertex, or none at all.
void check_value_count(JsonObject& attributes, const std::string& key, std::size_t values,
                       std::size_t vertices);

// The mesh at rest of a primitive of triangles (`mode` 4), a strip (5) or a fan (6) in its own
// coordinates, without normals if it has none, with the texture coordinates that its material uses;
// and its morph targets. What cannot be read is left out, with a warning, but for points and
// triangles.
Deformation read_gltf_mesh(GltfFile& file, JsonObject& primitive, std::int64_t mode,
                           std::span<const GltfTexcoords> texcoords);

// The member `weights` of a node or a mesh; empty if missing.
MorphWeights gltf_weights(GltfFile& file, JsonObject& object);

}  // namespace brume
