#pragma once

#include <glm/mat4x4.hpp>

#include "core/io/import/node_motion.h"
#include "core/scene/imported_scene.h"

namespace brume {

// The keys that place the mesh of a node that moves; `to_placed` transforms its points first.
struct NodeKeys {
  glm::dmat4 to_placed{1.0};
  PlacementKeys keys;  // none: it does not move
  // Placements stretch alike along all axes; what a node stretches otherwise is left out.
  bool is_stretched = false;
};

// Keys are at the times of the node's tracks, with others between where it does not move on
// straight lines by even turns; linear from each to the next, or constant where it stands still and
// jumps. Throws InputError where its transform has no coordinates, or for more than
// limits::keys_of_value.
NodeKeys placement_keys(const NodeMotion& motion, std::size_t node);

// Keys of a camera or a light of a node that moves, as of camera_of_node() around `pivot`.
void add_keys(const NodeMotion& motion, std::size_t node, const glm::dvec3& pivot,
              NamedCamera& camera);
void add_keys(const NodeMotion& motion, std::size_t node, Light& light);

}  // namespace brume
