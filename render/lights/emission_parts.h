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

// Those that lie in the open, where others are in solids or below the ground. Surfaces part them in
// two, by how many are crossed between any of them and the first: more are in the open, unless they
// see less than half as far.
std::vector<glm::dvec3> parts_in_the_open(const std::vector<glm::dvec3>& parts,
                                          const RayCaster& surfaces);

}  // namespace brume
