#pragma once

#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/io/import/node_motion.h"
#include "core/scene/deformation.h"

namespace brume {

// A node that moves vertices of a mesh.
struct Joint {
  std::optional<std::size_t> node{};  // of a NodeMotion; nullopt: the world, which stands
  glm::dmat4 to_node{1.0};            // from the mesh at rest
};

// The joints and weights that make a mesh deform.
struct DeformationMotion {
  std::vector<Joint> joints;
  MorphWeights weights{};                              // without a track
  std::shared_ptr<const Track<MorphWeights>> track{};  // null: none
};

Pose pose_at(const DeformationMotion& motion, const NodeMotion& nodes, double time);

// A deformation with poses at the times of the tracks, and others between where vertices do not
// move on straight lines. Null if it does not move. Throws InputError for too many poses, and where
// vertices have no coordinates.
std::shared_ptr<const Deformation> moving_deformation(Deformation deformation,
                                                      const DeformationMotion& motion,
                                                      const NodeMotion& nodes);

}  // namespace brume
