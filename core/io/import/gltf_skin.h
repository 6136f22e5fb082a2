#pragma once

#include <glm/mat4x4.hpp>
#include <map>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/io/import/gltf_nodes.h"

namespace brume {

// The skins of a glTF file, with their joints where the file's nodes put them: at rest.
class GltfSkins {
 public:
  // Both outlive this.
  GltfSkins(GltfFile& file, const std::vector<GltfNode>& nodes) : file_(file), nodes_(nodes) {}

  // The transforms of points at each joint of a node's skin: from the mesh to the world. Null if
  // the node has no skin, or one with joints outside the scene, with a warning. Valid as long as
  // this is.
  const std::vector<glm::dmat4>* joints(JsonObject& node);

 private:
  std::vector<glm::dmat4> read(std::size_t skin, const JsonPath& user);

  GltfFile& file_;
  const std::vector<GltfNode>& nodes_;
  std::map<std::size_t, std::vector<glm::dmat4>> skins_;
};

// Moves a primitive's points and normals into the world by the mean of its joints' matrices,
// weighted (glTF 2.0, 3.7.3.3). False, and nothing moved, if its attributes name no joints.
bool apply_skin(GltfFile& file, JsonObject& attributes, const std::vector<glm::dmat4>& joints,
                MeshArrays& mesh);

}  // namespace brume
