#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

namespace brume {

struct Scene;

// Frames from one to another, not whole ones.
struct FrameSpan {
  double first = 0.0;
  double last = 1.0;
};

// Current frame, playback, and what rulers of frames show. Editor state.
class Timeline : public QObject {
  Q_OBJECT
 public:
  explicit Timeline(QObject* parent);

  [[nodiscard]] int frame() const { return frame_; }
  [[nodiscard]] double time() const { return time_of(frame_); }  // [s]
  void set_frame(int frame);                                     // >= 0
  [[nodiscard]] double frames_per_second() const { return frames_per_second_; }
  [[nodiscard]] double time_of(double frame) const { return frame / frames_per_second_; }  // [s]
  [[nodiscard]] double frame_of(double time) const { return time * frames_per_second_; }
  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int last() const { return last_; }
  void set_range(int first, int last);  // clamped to 0 <= first <= last
  // The frames that rulers show: the range, unless others are asked for. `frames`: at least a
  // tenth of one; nullopt: the range again.
  [[nodiscard]] FrameSpan shown() const;
  void show_frames(std::optional<FrameSpan> frames);
  [[nodiscard]] bool loops() const { return loops_; }
  void set_loop(bool loops);
  // Keeps the frame: its time is another then.
  void set_frames_per_second(double rate);
  // Takes range, loop and rate from a scene; default: 0 to the end of its animation, at least 120
  // frames, looping.
  void follow(const Scene& scene);

  // Plays in real time, dropping frames, from the next frame on. Restarts from the first frame at
  // the end; loops or stops there.
  [[nodiscard]] bool is_playing() const { return timer_.isActive(); }
  void play();
  void stop();

 Q_SIGNALS:
  void frame_changed();
  void changed();  // any of the state

 private:
  void start_clock();  // and the timer
  void wait_for_next();
  void advance_frame();

  int frame_ = 0;
  double frames_per_second_ = 30.0;
  int first_ = 0;
  static constexpr int frames_at_first = 120;
  int last_ = frames_at_first;
  std::optional<FrameSpan> shown_;
  bool loops_ = true;
  QTimer timer_;
  QElapsedTimer clock_;
  int play_start_ = 0;
};

}  // namespace brume
