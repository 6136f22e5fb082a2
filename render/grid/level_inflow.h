#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/grid/node_layout.h"
#include "render/grid/resampling.h"
#include "render/util/job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Light that comes in at the border of a level from the coarser one around it.
class LevelInflow {
 public:
  LevelInflow(const NodeLayout& coarse, const NodeLayout& level);

  // From now on a border node takes light only of coarse nodes that surfaces do not hide from it, 0
  // if these hide all around: else light would come through walls. `blocked`: of the coarse nodes,
  // GridOcclusion::hidden(). In parallel.
  void see(const RayCaster& surfaces, std::span<const std::uint32_t> blocked, const Job& job);
  // inflow[i] = what arrives at border node i, of which around[k] arrives at coarse node k. Leaves
  // the other nodes.
  void apply(std::span<const float> around, std::span<float> inflow) const;

 private:
  struct BorderNode {
    std::size_t index;
    Resampling::Cell cell;  // of coarse nodes
    std::uint8_t hidden;    // bits of the cell's corners
  };

  NodeLayout coarse_, level_;
  Resampling resampling_;
  std::vector<BorderNode> border_;
};

}  // namespace brume
