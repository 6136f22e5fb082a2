#pragma once

#include <optional>
#include <span>
#include <string>

#include "brume/frame.h"
#include "render/deep/deep_file.h"

namespace brume {

// Run statistics of --stats besides those of the frames.
struct RenderRun {
  std::string scene;
  std::optional<int> frame{};  // its number in a sequence
  int repeat = 1;
  double first_frame_milliseconds = 0.0;     // with loading and building everything once
  std::optional<DeepFileStatistics> deep{};  // of the file, if it is deep
};

// The JSON of --stats for a frame that was asked for by a request. frame_ms and stages are over
// `moved`, the frames after it, at least one.
std::string statistics_json(const RenderRun& run, const Frame& frame,
                            std::span<const FrameStatistics> moved);

// The same for a sequence, from that of each frame.
std::string sequence_statistics_json(std::span<const std::string> frames);

}  // namespace brume
