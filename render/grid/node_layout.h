#pragma once

#include <glm/vec3.hpp>

#include "render/grid/axis_planes.h"
#include "render/grid/sweep_kernels.h"

namespace brume {

struct NodeLayout {
  glm::dvec3 first{0.0};  // position of node 0
  GridNodes nodes;
};

// Nodes from `low` to `high` or somewhat beyond, at the smallest spacing, at least `min_spacing`,
// with about `max_nodes` nodes: a layer more along each axis at most. Spacings are of a fixed
// series and layers of fixed places, off the planes: a medium that moves or grows a little moves no
// node, which would be seen as flicker.
NodeLayout lay_out(const glm::dvec3& low, const glm::dvec3& high, double min_spacing, int max_nodes,
                   const AxisPlanes& planes);

}  // namespace brume
