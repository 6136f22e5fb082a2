#pragma once

#include <span>
#include <vector>

#include "core/medium/medium.h"

namespace brume {

// Gaussians whose ball of one radius touches the ball of one of `ids`, those included; ordered by
// id. `ids` are of the medium.
std::vector<GaussianId> touching(const Medium& medium, std::span<const GaussianId> ids);

}  // namespace brume
