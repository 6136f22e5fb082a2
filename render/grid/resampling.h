#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/grid/sweep_kernels.h"
#include "render/util/job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Values of one grid at the nodes of another, trilinearly interpolated; beyond its border, those of
// the border.
class Resampling {
 public:
  // The grids' first nodes lie at `from_first` and `first`.
  Resampling(const glm::dvec3& from_first, const GridNodes& from, const glm::dvec3& first,
             const GridNodes& nodes);

  // From now on nodes of the border take values only of nodes that surfaces do not hide from them,
  // 0 if these hide all around: else light would come through walls. `blocked`: the other grid's
  // GridOcclusion::hidden(). In parallel.
  void see(const RayCaster& surfaces, std::span<const std::uint32_t> blocked, const Job& job);

  // At all nodes.
  void apply(std::span<const float> values, std::span<float> result) const;
  // At the nodes of the border; leaves the others.
  void apply_to_border(std::span<const float> values, std::span<float> result) const;

 private:
  // What a node lies in: the index of the first of the eight nodes around it, and how far it is
  // from there [cells].
  struct Cell {
    std::size_t first;
    glm::vec3 place;
  };
  [[nodiscard]] Cell cell_of(const glm::ivec3& node) const;
  // The eight nodes, x fastest, from the first on.
  [[nodiscard]] std::array<std::size_t, 8> corners() const;
  [[nodiscard]] float interpolated(std::span<const float> values, const Cell& cell) const;
  [[nodiscard]] float seen(std::span<const float> values, const Cell& cell,
                           std::uint8_t hidden) const;
  // Calls visit(node's index, node's coordinates) for those of the border on a slab.
  template <class Visit>
  void visit_border(int slab, Visit visit) const;

  GridNodes from_, nodes_;
  glm::dvec3 from_first_, first_;
  std::vector<std::uint8_t> hidden_;  // per node, bits of corners; empty: none are
  double scale_;
  glm::dvec3 offset_;
};

}  // namespace brume
