#pragma once

#include <span>
#include <vector>

#include "brume/medium.h"

namespace brume {

// Gaussians whose sphere of one radius touches that of one of `ids`, including these; ordered by
// id. `ids` must be in the medium.
std::vector<GaussianId> touching(const Medium& medium, std::span<const GaussianId> ids);

}  // namespace brume
