#pragma once

#include <span>
#include <string>

#include "render/frame.h"
#include "render/settings.h"

namespace brume {

// What --stats says of a run besides what the frames say themselves.
struct RenderRun {
  std::string scene;
  Film film;
  Settings settings;
  int repeat = 1;
  double first_frame_milliseconds = 0.0;  // with loading and building everything once
};

// The JSON of --stats. Counts are the first frame's; times are the medians over `frames`, which
// are the ones after the first if there are more.
std::string statistics_json(const RenderRun& run, const FrameStatistics& first,
                            std::span<const FrameStatistics> frames);

}  // namespace brume
