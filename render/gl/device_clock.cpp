#include "render/gl/device_clock.h"

#include <algorithm>

namespace brume::gl {

void DeviceClock::collect(std::vector<StageTime>& stages) {
  const std::size_t first = stages.size();
  for (std::size_t i = 0; i < used_; ++i) {
    const Stage& stage = timers_[i];
    const auto begin = stages.begin() + static_cast<std::ptrdiff_t>(first);
    const auto same = std::find_if(
        begin, stages.end(), [&](const StageTime& known) { return known.name == stage.name; });
    if (same != stages.end()) {
      same->milliseconds += stage.timer.milliseconds();
    } else {
      stages.push_back({stage.name, stage.timer.milliseconds()});
    }
  }
  used_ = 0;
}

}  // namespace brume::gl
