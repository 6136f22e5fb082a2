#include "render/gl/device_clock.h"

namespace brume::gl {

void DeviceClock::collect(std::vector<StageTime>& stages) {
  for (std::size_t i = 0; i < used_; ++i) {
    add_time(stages, timers_[i].stage, timers_[i].timer.milliseconds());
  }
  used_ = 0;
}

}  // namespace brume::gl
