#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/geometry/medium_index.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// A Gaussian that emits.
struct EmittingGaussian {
  std::size_t index;
  glm::dvec3 intensity;  // unattenuated [W/sr]
  double weight;         // the same of all channels
};

// `count` points that emit alike, spread as Gaussians emit [u].
std::vector<glm::dvec3> emission_parts(std::span<const EmittingGaussian> emitters,
                                       const MediumIndex& medium, int count);

// Whether the number of surfaces between two points is even: both are in one solid, or neither is.
// Panes do not count.
bool are_on_one_side(const glm::dvec3& a, const glm::dvec3& b, const RayCaster& surfaces);

// The parts that lie in the open, where others are in solids or below the ground: those on the side
// of more of them, unless these see less than half as far. Never empty.
std::vector<glm::dvec3> parts_in_the_open(const std::vector<glm::dvec3>& parts,
                                          const RayCaster& surfaces);

}  // namespace brume
