#include "app/document/time/timeline.h"

#include <algorithm>
#include <cmath>

#include "brume/at_time.h"
#include "brume/limits.h"

namespace brume {

Timeline::Timeline(QObject* parent) : QObject(parent) {
  timer_.setTimerType(Qt::PreciseTimer);  // a coarse one drops frames
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &Timeline::advance_frame);
}

void Timeline::set_frame(int frame) {
  frame = std::max(frame, 0);
  if (frame == frame_) return;
  frame_ = frame;
  if (is_playing()) start_clock();
  Q_EMIT frame_changed();
  Q_EMIT changed();
}

void Timeline::set_range(int first, int last) {
  first_ = std::max(first, 0);
  last_ = std::max(last, first_);
  Q_EMIT changed();
}

FrameSpan Timeline::shown() const {
  return shown_.value_or(
      FrameSpan{static_cast<double>(first_), static_cast<double>(std::max(last_, first_ + 1))});
}

void Timeline::show_frames(std::optional<FrameSpan> frames) {
  constexpr double min_length = 0.1;
  constexpr double max_length = 2.0 * limits::frame;
  if (frames) {
    const double length = std::clamp(frames->last - frames->first, min_length, max_length);
    const double first = std::clamp<double>(frames->first, -limits::frame, limits::frame);
    frames = FrameSpan{first, first + length};
  }
  shown_ = frames;
  Q_EMIT changed();
}

void Timeline::set_frames_per_second(double rate) {
  if (rate == frames_per_second_) return;
  frames_per_second_ = rate;
  if (is_playing()) start_clock();
  Q_EMIT frame_changed();
  Q_EMIT changed();
}

void Timeline::follow(const Scene& scene) {
  set_frames_per_second(frame_rate(scene));
  if (const auto& playback = scene.playback) {
    set_loop(playback->loops);
    set_range(playback->first, playback->last);
    return;
  }
  const double last = std::ceil(last_moment(scene) * frames_per_second_ - 1e-6);
  set_loop(true);
  set_range(0, static_cast<int>(std::clamp<double>(last, frames_at_first, limits::frame)));
}

void Timeline::set_loop(bool loops) {
  loops_ = loops;
  Q_EMIT changed();
}

void Timeline::play() {
  // The frame shown is known already: the next one follows at once.
  const bool restarts = frame_ < first_ || frame_ >= last_;
  frame_ = restarts ? first_ : frame_ + 1;
  start_clock();
  Q_EMIT frame_changed();
  Q_EMIT changed();
}

void Timeline::stop() {
  timer_.stop();
  Q_EMIT changed();
}

void Timeline::start_clock() {
  play_start_ = frame_;
  clock_.start();
  wait_for_next();
}

void Timeline::wait_for_next() {
  // A timer of a whole number of milliseconds would come before its frame, and miss it.
  constexpr int min_wait = 8;  // milliseconds: no screen shows more
  const double next = 1e3 * (frame_ - play_start_ + 1) / frames_per_second_;
  const auto wait = static_cast<int>(std::ceil(next)) - static_cast<int>(clock_.elapsed());
  timer_.start(std::max(min_wait, wait));
}

void Timeline::advance_frame() {
  const double played = static_cast<double>(clock_.elapsed()) * 1e-3 * frames_per_second_;
  int frame = play_start_ + static_cast<int>(played);
  bool goes_on = true;
  if (frame > last_) {
    if (loops_) {
      // Time goes on: a restarted clock would lose a part of a frame in each loop.
      const int wrapped = first_ + (frame - first_) % (last_ - first_ + 1);
      play_start_ -= frame - wrapped;
      frame = wrapped;
    } else {
      frame = last_;
      goes_on = false;
    }
  }
  const bool is_other = frame_ != frame;
  frame_ = frame;
  if (goes_on) wait_for_next();
  if (is_other) Q_EMIT frame_changed();
  Q_EMIT changed();
}

}  // namespace brume
