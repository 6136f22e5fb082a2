#include "app/document/timeline.h"

#include <algorithm>
#include <cmath>

#include "brume/at_time.h"
#include "brume/limits.h"

namespace brume {

Timeline::Timeline(QObject* parent) : QObject(parent) {
  timer_.setInterval(static_cast<int>(1000.0 / frames_per_second_));
  timer_.setTimerType(Qt::PreciseTimer);  // a coarse one drops frames
  connect(&timer_, &QTimer::timeout, this, &Timeline::advance_frame);
}

void Timeline::set_frame(int frame) {
  frame = std::max(frame, 0);
  if (frame == frame_) return;
  frame_ = frame;
  if (is_playing()) {
    play_start_ = frame;
    clock_.restart();
  }
  Q_EMIT frame_changed();
  Q_EMIT changed();
}

void Timeline::set_range(int first, int last) {
  first_ = std::max(first, 0);
  last_ = std::max(last, first_);
  Q_EMIT changed();
}

void Timeline::set_frames_per_second(double rate) {
  if (rate == frames_per_second_) return;
  frames_per_second_ = rate;
  constexpr int min_interval = 8;  // milliseconds: no screen shows more
  timer_.setInterval(std::max(min_interval, static_cast<int>(1000.0 / rate)));
  if (is_playing()) {
    play_start_ = frame_;
    clock_.restart();
  }
  Q_EMIT frame_changed();
  Q_EMIT changed();
}

void Timeline::follow(const Scene& scene) {
  set_frames_per_second(scene.playback ? scene.playback->frames_per_second : default_frame_rate);
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
  if (frame_ < first_ || frame_ >= last_) set_frame(first_);
  play_start_ = frame_;
  clock_.start();
  timer_.start();
  Q_EMIT changed();
}

void Timeline::stop() {
  timer_.stop();
  Q_EMIT changed();
}

void Timeline::advance_frame() {
  const double played = static_cast<double>(clock_.elapsed()) * 1e-3 * frames_per_second_;
  int frame = play_start_ + static_cast<int>(played);
  if (frame > last_) {
    if (loops_) {
      // Time goes on: a restarted clock would lose a part of a frame in each loop.
      const int wrapped = first_ + (frame - first_) % (last_ - first_ + 1);
      play_start_ -= frame - wrapped;
      frame = wrapped;
    } else {
      frame = last_;
      timer_.stop();
    }
  }
  if (frame != frame_) {
    frame_ = frame;
    Q_EMIT frame_changed();
  }
  Q_EMIT changed();
}

}  // namespace brume
