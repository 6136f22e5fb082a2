#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace brume {

struct Scene;

// The frame that is shown, and playing. State of the editor.
class Timeline : public QObject {
  Q_OBJECT
 public:
  explicit Timeline(QObject* parent);

  static constexpr double frames_per_second = 30.0;

  [[nodiscard]] int frame() const { return frame_; }
  [[nodiscard]] double time() const { return frame_ / frames_per_second; }  // [s]
  void set_frame(int frame);                                                // >= 0
  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int last() const { return last_; }
  void set_range(int first, int last);  // 0 <= first <= last, or what comes nearest
  [[nodiscard]] bool loops() const { return loops_; }
  void set_loop(bool loops);
  // Range and loop of a scene; where it has none, from 0 to the last of what moves in it, 120
  // frames at least, again and again.
  void follow(const Scene& scene);

  // In real time: frames that cannot be shown in time are left out. From the first frame if the
  // last is shown; on, from the first again, or to a stop at the last.
  [[nodiscard]] bool is_playing() const { return timer_.isActive(); }
  void play();
  void stop();

 Q_SIGNALS:
  void frame_changed();
  void changed();  // anything, playing or not included

 private:
  void go_on();

  int frame_ = 0;
  int first_ = 0;
  static constexpr int frames_at_first = 120;
  int last_ = frames_at_first;
  bool loops_ = true;
  QTimer timer_;
  QElapsedTimer clock_;
  int played_from_ = 0;
};

}  // namespace brume
