#pragma once

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <glm/mat4x4.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/io/import/node_motion.h"
#include "core/io/import/poses.h"

namespace brume {

glm::dmat4 to_dmat4(const aiMatrix4x4& m);

// The joints that are a mesh's bones and the vertices that they move; the last one is the mesh's
// own `node`, which moves those that no bone does. Bones that are no nodes (`names`) move none.
std::vector<Joint> read_bones(const aiMesh& mesh, const std::map<std::string, std::size_t>& names,
                              std::size_t node, Deformation& deformation);

// Reads the morph targets of a mesh that a node shows, and the weights that the scene's first
// animation gives them; none without such, since nobody knows their weights at rest then.
std::shared_ptr<const Track<MorphWeights>> read_morph(const aiScene& scene, const aiMesh& mesh,
                                                      const aiNode& node, Deformation& deformation);

double ticks_per_second(const aiAnimation& animation);

// Sets the tracks of nodes by a scene's first animation. `names`: of nodes, the first of which is
// the root, which does not move.
void add_tracks(const aiScene& scene, const std::map<std::string, std::size_t>& names,
                std::vector<MovingNode>& nodes);

}  // namespace brume
