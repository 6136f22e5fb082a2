#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "render/grid/node_layout.h"
#include "render/grid/sweep_kernels.h"

namespace brume {

// Values of one grid at the nodes of another, trilinearly interpolated; beyond its border, those of
// the border.
class Resampling {
 public:
  // The cell that a node lies in: the index of the first of the eight nodes around it, and how far
  // it is from there [cells].
  struct Cell {
    std::size_t first;
    glm::vec3 place;

    // Weights of the eight nodes, x fastest.
    [[nodiscard]] std::array<float, 8> weights() const;
  };

  // From the nodes of one grid to those of another.
  Resampling(const NodeLayout& source, const NodeLayout& target);

  [[nodiscard]] Cell cell_of(const glm::ivec3& node) const;
  // The eight nodes of a cell, x fastest, from its first on.
  [[nodiscard]] std::array<std::size_t, 8> corners() const;
  // At all nodes.
  void apply(std::span<const float> values, std::span<float> result) const;

 private:
  GridNodes source_, target_;
  double scale_;
  glm::dvec3 offset_;
};

}  // namespace brume
