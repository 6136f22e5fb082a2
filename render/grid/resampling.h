#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "render/grid/sweep_kernels.h"

namespace brume {

// Values of one grid at the nodes of another, trilinearly interpolated; beyond its border, those of
// the border.
class Resampling {
 public:
  // The grids' first nodes lie at `from_first` and `first`.
  Resampling(const glm::dvec3& from_first, const GridNodes& from, const glm::dvec3& first,
             const GridNodes& nodes);

  // At all nodes.
  void apply(std::span<const float> values, std::span<float> result) const;
  // At the nodes of the border; leaves the others.
  void apply_to_border(std::span<const float> values, std::span<float> result) const;

 private:
  [[nodiscard]] float at(std::span<const float> values, const glm::ivec3& node) const;

  GridNodes from_, nodes_;
  double scale_;
  glm::dvec3 offset_;
};

}  // namespace brume
