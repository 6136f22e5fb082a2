#pragma once

#include <QWidget>
#include <optional>
#include <vector>

class QPainter;

namespace brume {

class Timeline;

// The frames across a widget: those that the timeline shows, with a margin at both ends.
class FrameScale {
 public:
  // `left`, `width`: of the widget's part [pixels].
  FrameScale(const Timeline& timeline, double left, double width);

  [[nodiscard]] double x_of(double frame) const;
  [[nodiscard]] double frame_at(double x) const;
  [[nodiscard]] double frames_per_pixel() const { return frames_per_pixel_; }
  // The frame that the playhead is dragged to: not behind the range, unless it is there already.
  [[nodiscard]] int scrub_frame(double x) const;

  // Frames that have a line, far enough apart for their numbers.
  [[nodiscard]] std::vector<double> ticks() const;
  // Vertical lines at the ticks, shade beyond the range, and the playhead.
  void paint_lines(QPainter& painter, const QWidget& widget) const;

 private:
  const Timeline& timeline_;
  double left_;
  double width_;
  double first_;
  double frames_per_pixel_;
};

// Zooms and moves the frames that all rulers show.
void zoom_frames(Timeline& timeline, const FrameScale& scale, double x, double factor);
void pan_frames(Timeline& timeline, const FrameScale& scale, double pixels);
// Shows the range, and keyframes beyond it until some time [s].
void fit_frames(Timeline& timeline, double last_key);

// A rectangle around what is to be selected.
void paint_rubber_band(QPainter& painter, const QRectF& area);

// A step of 1, 2 or 5 times a power of ten, at least `step`.
double round_step(double step);

// A ruler of frames, of the timeline and of the curves: ticks, numbers and the playhead, which a
// drag moves. The wheel zooms, the middle button pans, a double click shows the range. Below it a
// bar shows which frames are cached.
class TimeRuler : public QWidget {
  Q_OBJECT
 public:
  static constexpr int ruler_height = 24;  // pixels

  TimeRuler(Timeline& timeline, QWidget* parent);

  [[nodiscard]] FrameScale scale() const;

  // A frame whose picture is kept: at full quality, or as it was in motion.
  struct Cached {
    int frame;
    bool full;
    bool operator==(const Cached&) const = default;
  };
  void set_cached(std::vector<Cached> frames);
  [[nodiscard]] const std::vector<Cached>& cached() const { return cached_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void paint_cached(QPainter& painter) const;
  void scrub_to(double x);

  Timeline& timeline_;
  std::vector<Cached> cached_;
  std::optional<double> pan_x_;  // of the mouse, while it pans
};

}  // namespace brume
