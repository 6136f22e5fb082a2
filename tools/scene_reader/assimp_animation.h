#pragma once

#include <assimp/scene.h>

#include <map>
#include <string>
#include <vector>

#include "core/io/import/node_motion.h"

namespace brume {

double ticks_per_second(const aiAnimation& animation);

// Sets the tracks of nodes by a scene's first animation. `names`: of nodes, the first of which is
// the root, which does not move.
void add_tracks(const aiScene& scene, const std::map<std::string, std::size_t>& names,
                std::vector<MovingNode>& nodes);

}  // namespace brume
