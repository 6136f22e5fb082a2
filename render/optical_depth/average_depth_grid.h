#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/transport/optical_depth.h"
#include "render/geometry/box.h"

namespace brume {

// Average optical depth Tbar(p) of Gaussians (core/transport/average_depth.h) on a grid over a box,
// trilinearly interpolated. Nothing can be culled, so each node sums all Gaussians; the more
// Gaussians, the fewer nodes.
class AverageDepthGrid {
 public:
  // In parallel. Spacing is a quarter of the smallest radius, or larger to stay within 32,768 nodes
  // and 5e7 evaluations.
  AverageDepthGrid(std::span<const GaussianTerm<double>> gaussians, const Box& box);

  // Clamped to the box.
  [[nodiscard]] float operator()(const glm::dvec3& p) const;

  // Data for look-ups on a device.
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
