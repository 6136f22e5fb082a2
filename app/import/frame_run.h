#pragma once

#include <filesystem>
#include <vector>

#include "brume/medium_sequence.h"
#include "core/io/frame_pattern.h"

namespace brume {

// A run of frames: the files of a pattern, without a gap.
struct FrameRun {
  FramePattern files;
  int first = 0;
  int last = 0;
};

// The contiguous frames around a file. Throws InputError if it is no frame.
FrameRun frames_around(const std::filesystem::path& file);

// Writes the frames of a run as PLY files `names`, with their numbers, into a folder that is made
// if it is not there. Throws InputError.
MediumSequence write_sequence(const std::filesystem::path& names, const FrameRun& run,
                              std::vector<SequenceFrame> frames);

}  // namespace brume
