#pragma once

#include <vector>

#include "brume/frame.h"
#include "render/gl/resources.h"

namespace brume::gl {

// GPU times of the stages of a frame.
class DeviceClock {
 public:
  // Drops the stages of a cancelled frame.
  void restart() { used_ = 0; }
  // Runs `work`, which submits the commands of a stage.
  template <class Work>
  auto time(Stage stage, Work work) {
    if (used_ == timers_.size()) timers_.emplace_back();
    TimedStage& now = timers_[used_++];
    now.stage = stage;
    now.timer.begin();
    struct End {
      Timer& timer;
      ~End() { timer.end(); }
    } end{now.timer};
    return work();
  }

  // Adds the times of the stages since the last call. Waits for the device.
  void collect(std::vector<StageTime>& stages);

 private:
  struct TimedStage {
    Stage stage = Stage::frame;
    Timer timer;
  };
  std::vector<TimedStage> timers_;
  std::size_t used_ = 0;
};

}  // namespace brume::gl
