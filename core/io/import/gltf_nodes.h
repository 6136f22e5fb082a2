#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

#include "core/io/import/gltf_file.h"
#include "core/io/import/node_motion.h"

namespace brume {

struct GltfNode {
  std::size_t element = 0;              // of the list `nodes`
  std::optional<std::size_t> parent{};  // of read_gltf_nodes()
  glm::dmat4 to_world{1.0};             // affine; entries of domain::coordinate
  glm::dmat4 to_parent{1.0};
  NodeTransform transform{};  // which that is, unless the file has a matrix
};

// The nodes of the file's scene, of all nodes if it has none; parents before their children. Throws
// InputError if they are no trees, if a transform is no matrix of coordinates, or for more than
// max_imported_nodes.
std::vector<GltfNode> read_gltf_nodes(GltfFile& file);

// The member `key` of an object, a list of elements of the list `nodes`; empty if missing.
std::vector<std::size_t> gltf_node_indices(GltfFile& file, JsonObject& object, const char* key);

}  // namespace brume
