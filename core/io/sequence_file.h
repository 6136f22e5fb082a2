#pragma once

#include <functional>
#include <vector>

#include "core/io/frame_pattern.h"
#include "core/scene/medium_sequence.h"

namespace brume {

// Reads one file of Gaussians per frame (core/io/gaussian_file.h), with the number of each in its
// column `id`; where files have none, Gaussians of the same line are the same. Throws InputError
// naming file and place: also for an id twice in a file, and for more than limits::gaussians in
// all.
std::vector<SequenceFrame> read_sequence(const FramePattern& files, int first, int last);

}  // namespace brume
