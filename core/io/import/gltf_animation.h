#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/io/import/gltf_nodes.h"
#include "core/io/import/node_motion.h"
#include "core/io/import/poses.h"

namespace brume {

// The effects of the file's first animation on nodes, in their order.
struct GltfAnimation {
  std::vector<NodeTracks> tracks;
  std::vector<std::shared_ptr<const Track<MorphWeights>>> weights;  // null: not animated
};

// Other animations, and those of anything else, are left out with a warning. Throws InputError
// where times do not ascend, or numbers are missing or none.
GltfAnimation read_gltf_animation(GltfFile& file, const std::vector<GltfNode>& nodes);

// The skins of a glTF file.
class GltfSkins {
 public:
  // Both outlive this.
  GltfSkins(GltfFile& file, const std::vector<GltfNode>& nodes) : file_(file), nodes_(nodes) {}

  // The joints of a node's skin. Null if the node has no skin, or one with joints outside the
  // scene, with a warning. Valid as long as this is.
  const std::vector<Joint>* joints(JsonObject& node);

 private:
  std::vector<Joint> read(std::size_t skin, const JsonPath& user);

  GltfFile& file_;
  const std::vector<GltfNode>& nodes_;
  std::map<std::size_t, std::vector<Joint>> skins_;
};

// Reads what the joints move of a primitive (glTF 2.0, 3.7.3.3). Weights add up to whatever they
// do, and count by their share; a vertex without any is its first joint's. Joints without weight
// need not exist. None if the primitive's attributes name no joints.
void read_gltf_influences(GltfFile& file, JsonObject& attributes, std::size_t joints,
                          Deformation& deformation);

}  // namespace brume
