#pragma once

#include <glm/vec3.hpp>

#include "render/grid/axis_planes.h"
#include "render/grid/sweep_kernels.h"

namespace brume {

struct NodeLayout {
  glm::dvec3 first{0.0};  // position of node 0
  GridNodes nodes;
};

// Nodes from `low` to `high` at the smallest spacing, at least `min_spacing`, with at most
// `max_nodes` nodes. Where planes lie on layers of them, there is one layer more, and all are moved
// off the planes. The spacing is a float, to be identical wherever it is used.
NodeLayout lay_out(const glm::dvec3& low, const glm::dvec3& high, double min_spacing, int max_nodes,
                   const AxisPlanes& planes);

}  // namespace brume
