#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/transport/optical_depth.h"
#include "render/cpu/box.h"

namespace brume {

// Tbar(p) of Gaussians (core/transport/average_depth.h) in a box, on a grid and interpolated
// linearly in between. It does not fall off fast enough to leave anything out, so each node sums
// all Gaussians; where there are many, the nodes are fewer.
class AverageDepthGrid {
 public:
  // In parallel. Nodes stand a quarter of the smallest radius apart, or farther where they would be
  // more than 32,768 or cost more than 5e7 evaluations.
  AverageDepthGrid(std::span<const GaussianTerm<double>> gaussians, const Box& box);

  // For p in the box; outside, the value at the nearest point of it.
  [[nodiscard]] float operator()(const glm::dvec3& p) const;

  // What a look-up needs.
  [[nodiscard]] const glm::dvec3& low() const { return box_.low; }
  [[nodiscard]] const glm::dvec3& cells_per_unit() const { return cells_per_unit_; }
  [[nodiscard]] const glm::ivec3& nodes() const { return nodes_; }
  [[nodiscard]] std::span<const float> depths() const { return depths_; }  // x fastest

 private:
  Box box_;
  glm::ivec3 nodes_{1};  // along each axis
  glm::dvec3 cells_per_unit_{0.0};
  std::vector<float> depths_;  // x fastest
};

}  // namespace brume
