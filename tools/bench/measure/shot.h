#pragma once

#include <functional>
#include <string>
#include <vector>

namespace brume {

// Frames of an animation rendered by several programs at once, which share the cores.
struct ShotRow {
  int workers = 0;
  double seconds = 0.0;
  double frames_per_hour = 0.0;
  double lost = 0.0;  // share of the time in which nothing is rendered: reading, waiting for files
};

// Runs `brume` with arguments; returns what it prints. Throws if it fails.
using RunBrume = std::function<std::string(const std::vector<std::string>&)>;

// With one worker and with two. Throws if they do not make the same files, byte for byte.
std::vector<ShotRow> measure_shot(const RunBrume& run_brume, bool quick);

}  // namespace brume
