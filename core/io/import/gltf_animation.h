#pragma once

#include <memory>
#include <vector>

#include "core/io/import/gltf_nodes.h"
#include "core/io/import/node_motion.h"

namespace brume {

// The effects of the file's first animation on nodes, in their order.
struct GltfAnimation {
  std::vector<NodeTracks> tracks;
  std::vector<std::shared_ptr<const Track<MorphWeights>>> weights;  // null: not animated
};

// Other animations, and those of anything else, are left out with a warning. Throws InputError
// where times do not ascend, or numbers are missing or none.
GltfAnimation read_gltf_animation(GltfFile& file, const std::vector<GltfNode>& nodes);

}  // namespace brume
