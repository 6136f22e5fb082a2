#pragma once

#include <vector>

#include "brume/medium_sequence.h"

namespace brume {

// The indices of the frames that a sequence's Gaussians at a time [s] come from: one, or two
// neighbours; none of no frames.
std::vector<int> frames_at(const MediumSequence& sequence, double time);

}  // namespace brume
