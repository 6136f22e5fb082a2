#pragma once

#include <vector>

#include "render/frame.h"
#include "render/gl/resources.h"

namespace brume::gl {

// GPU times of the stages of a frame.
class DeviceClock {
 public:
  // Drops the stages of a cancelled frame.
  void restart() { used_ = 0; }
  // Runs `work`, which submits the commands of a stage.
  template <class Work>
  auto time(const char* stage, Work work) {
    if (used_ == timers_.size()) timers_.emplace_back();
    Stage& now = timers_[used_++];
    now.name = stage;
    now.timer.begin();
    struct End {
      Timer& timer;
      ~End() { timer.end(); }
    } end{now.timer};
    return work();
  }

  // Appends the stages since the last call, merging those of one name. Waits for the device.
  void collect(std::vector<StageTime>& stages);

 private:
  struct Stage {
    const char* name = "";
    Timer timer;
  };
  std::vector<Stage> timers_;
  std::size_t used_ = 0;
};

}  // namespace brume::gl
