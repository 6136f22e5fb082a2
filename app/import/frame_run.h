#pragma once

#include <filesystem>

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

}  // namespace brume
