#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/formulas/shared_struct.h"
#include "render/visibility/ray_caster.h"

namespace brume {

BRUME_SHARED_STRUCT(BvhChild, {
  glm::vec3 low{0.0f};
  std::int32_t first = -1;  // leaf: index in `order`; else: node index; < 0: empty
  glm::vec3 high{0.0f};
  std::int32_t count = 0;  // triangles in a leaf; 0: inner node
});
BRUME_SHARED_STRUCT(BvhNode, { BvhChild children[2]; });

// A bounding-volume hierarchy of triangles for devices that Embree does not run on; built by
// Embree.
struct TriangleBvh {
  using Child = BvhChild;
  using Node = BvhNode;
  // Maximum depth of the tree.
  static constexpr int max_levels = 48;

  std::vector<Node> nodes;           // the root is nodes[0]; empty without triangles
  std::vector<std::uint32_t> order;  // triangle indices of leaves

  // Ignores triangles beyond 1.8e18, as Embree does.
  explicit TriangleBvh(std::span<const WorldTriangle> triangles);
};

}  // namespace brume
