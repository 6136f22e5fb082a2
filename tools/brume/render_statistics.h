#pragma once

#include <optional>
#include <span>
#include <string>

#include "brume/frame.h"
#include "render/deep/deep_file.h"
#include "render/quality/error_estimate.h"
#include "render/settings.h"

namespace brume {

// Run statistics of --stats besides those of the frames.
struct RenderRun {
  std::string scene;
  std::optional<int> frame{};  // its number in a sequence
  double time = 0.0;           // [s]
  Film film;
  Settings settings;  // `threads` as they ran
  int repeat = 1;
  double first_frame_milliseconds = 0.0;     // with loading and building everything once
  double transfer_milliseconds = 0.0;        // of those, for radiance transfer
  std::optional<ErrorEstimate> error{};      // of the first frame
  std::optional<RelativeNoise> noise{};      // of the first frame, if path-traced
  std::optional<DeepFileStatistics> deep{};  // of the file, if it is deep
};

// The JSON of --stats for one frame. Counts are those of the first frame; frame_ms and stages are
// over `moved`, the frames after it, at least one.
std::string statistics_json(const RenderRun& run, const FrameStatistics& first,
                            std::span<const FrameStatistics> moved);

// The same for a sequence, from that of each frame.
std::string sequence_statistics_json(std::span<const std::string> frames);

}  // namespace brume
