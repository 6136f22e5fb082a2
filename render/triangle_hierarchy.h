#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/cpu/visibility.h"

namespace brume {

// A tree of boxes around triangles, for rays on devices that Embree does not run on; built by
// Embree.
struct TriangleHierarchy {
  struct Child {
    glm::vec3 low{0.0f};
    std::int32_t first = -1;  // of a leaf: in `order`; else the node; < 0: there is nothing
    glm::vec3 high{0.0f};
    std::int32_t count = 0;  // triangles of a leaf; 0: a node
  };
  struct Node {
    Child children[2];
  };
  // A path down has at most this many nodes.
  static constexpr int most_levels = 48;

  std::vector<Node> nodes;           // the root is the first; none without triangles
  std::vector<std::uint32_t> order;  // of leaves: triangles

  // Those that Embree leaves out, beyond 1.8e18, are left out.
  explicit TriangleHierarchy(std::span<const PlacedTriangle> triangles);
};

}  // namespace brume
