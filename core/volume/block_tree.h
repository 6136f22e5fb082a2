#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brume/density_grid.h"

namespace brume {

// Finds the blocks of a grid along lines, in a time that follows the blocks and not their
// distances.
class BlockTree {
 public:
  explicit BlockTree(std::span<const DensityGrid::Block> blocks);

  // Parameters of a line p + t w, [voxels].
  struct Interval {
    double begin;
    double end;
  };
  // Where the trilinear density along a line may be other than 0: in order, apart.
  [[nodiscard]] std::vector<Interval> intervals(const glm::dvec3& p, const glm::dvec3& w) const;

 private:
  // A box around the blocks [first, first + count) of `corners_`. Children follow their parent:
  // the first at once, the second at `second`; 0: none.
  struct Node {
    glm::ivec3 low, high;
    std::size_t first, count;
    std::size_t second = 0;
  };

  void split(std::size_t first, std::size_t count);

  std::vector<glm::ivec3> corners_;
  std::vector<Node> nodes_;
};

}  // namespace brume
