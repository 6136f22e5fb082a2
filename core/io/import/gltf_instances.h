#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "brume/copies.h"
#include "core/io/import/gltf_file.h"

namespace brume {

// The transforms of a node's instances within it (EXT_mesh_gpu_instancing); without any, the node
// is its only one.
std::vector<glm::dmat4> gltf_instances(GltfFile& file, JsonObject& node);

// Transforms as placements; empty: one of them stretches or mirrors.
CopyPlacements placements_of(std::span<const glm::dmat4> transforms);

}  // namespace brume
