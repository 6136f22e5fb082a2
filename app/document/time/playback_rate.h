#pragma once

#include <cstdint>
#include <deque>

namespace brume {

// How many frames a second playback shows, over the last second.
class PlaybackRate {
 public:
  // `now` [ms] of any clock that never goes back.
  void start(std::int64_t now);
  // A picture is shown; another one of the same frame does not count.
  void show(int frame, std::int64_t now);
  // Frames per second; 0 until there is enough to tell.
  [[nodiscard]] double measured(std::int64_t now) const;

 private:
  std::int64_t start_ = 0;
  int last_frame_ = -1;
  std::deque<std::int64_t> shown_;
};

}  // namespace brume
