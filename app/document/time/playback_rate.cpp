#include "app/document/time/playback_rate.h"

#include <algorithm>

namespace brume {
namespace {

constexpr std::int64_t window = 1000;  // milliseconds
constexpr std::int64_t enough = 500;

}  // namespace

void PlaybackRate::start(std::int64_t now) {
  start_ = now;
  last_frame_ = -1;
  shown_.clear();
}

void PlaybackRate::show(int frame, std::int64_t now) {
  if (frame == last_frame_) return;
  last_frame_ = frame;
  shown_.push_back(now);
  while (now - shown_.front() >= window) shown_.pop_front();
}

double PlaybackRate::measured(std::int64_t now) const {
  const std::int64_t length = std::min(window, now - start_);
  if (length < enough) return 0.0;
  const auto count =
      std::ranges::count_if(shown_, [&](std::int64_t time) { return now - time < length; });
  return static_cast<double>(count) * 1e3 / static_cast<double>(length);
}

}  // namespace brume
