#include "tools/brume/run_frames.h"

#include <string>

#include "tools/brume/interruption.h"

namespace brume {

ExitCode run_frames(std::span<const int> frames, const FrameLoop::Make& make) {
  FrameLoop::Steps steps;
  steps.make = [&](int frame, const std::string& label) {
    check_interrupted();
    return make(frame, label);
  };
  steps.failed = [](int frame, const std::string& why) {
    print_note("error: frame " + std::to_string(frame) + ": " + why);
  };
  return FrameLoop::run(frames, steps).failed.empty() ? done : check_failed;
}

}  // namespace brume
