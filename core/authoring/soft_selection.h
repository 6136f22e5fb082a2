#pragma once

#include <span>
#include <vector>

#include "brume/medium.h"

namespace brume {

// How much a Gaussian takes part in a move of others near it.
struct SoftMember {
  std::size_t index = 0;  // of the medium
  double weight = 0.0;    // in (0, 1)

  bool operator==(const SoftMember&) const = default;
};

// The Gaussians that are not in `ids` (sorted) but whose centers are nearer than `radius` > 0 [u]
// to that of one that is; by index. The weight falls smoothly from 1 there to 0 at the radius.
std::vector<SoftMember> soft_members(const Medium& medium, std::span<const GaussianId> ids,
                                     double radius);

}  // namespace brume
