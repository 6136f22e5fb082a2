#pragma once

#include <glm/gtc/quaternion.hpp>
#include <memory>

#include "tools/bench/scenes/mesh_patches.h"

namespace brume {

// A copy turned by q about the origin.
std::shared_ptr<TriangleMesh> turned(const TriangleMesh& mesh, const glm::dquat& q);

}  // namespace brume
