#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "render/scattering/source_grid.h"

namespace brume {

// Which nodes of a grid an eye sees, as far as look-ups ask. A point that it sees has light from
// nodes that the corner of their cell towards the eye sees. In the layer of cells that holds the
// eye itself both sides are towards it, and one of them may be behind a surface: below the ground
// that the eye stands on.
struct NodeVisibility {
  // A layer of cells of a level along each axis: the side of its nodes that counts there.
  struct Layers {
    glm::ivec3 cell{-1};  // -1: none
    glm::ivec3 is_high{0};
  };

  // The bits of GridOcclusion::hidden() that count: within a closed room, which has no other nodes,
  // not enclosed_bit.
  std::uint32_t occlusion_bits = GridOcclusion::all_bits;
  std::array<Layers, SourceGrid::max_levels> layers{};

  NodeVisibility() = default;  // from a place without surfaces
  NodeVisibility(const SourceGrid& grid, const glm::dvec3& eye);
};

}  // namespace brume
