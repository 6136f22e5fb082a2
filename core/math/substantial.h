#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace brume {

// A Gaussian as the extent of a medium is measured by it.
struct GaussianExtent {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};
  double depth = 0.0;  // optical, through the center
  bool emits = false;
};

// The Gaussians by which the extent of a medium is measured, as ascending indices: all, or without
// the thinnest if what is left is at most half as long. The optical depths of these are together at
// most 0.01, and a hundredth of the sum of all; none of them emits. So one that hardly scatters,
// far from the others, makes nothing coarser.
std::vector<std::size_t> substantial_gaussians(std::span<const GaussianExtent> gaussians);

}  // namespace brume
