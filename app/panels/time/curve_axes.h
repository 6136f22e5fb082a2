#pragma once

#include <QPointF>
#include <QSizeF>
#include <vector>

#include "app/document/time/keyframe_curves.h"
#include "app/panels/time/time_ruler.h"

class QPainter;

namespace brume {

class Timeline;

// The part of the plane of times and values that a curve editor shows: the frames of the timeline,
// and of each track the values of an axis of its own, since tracks have different units.
class CurveAxes {
 public:
  explicit CurveAxes(const Timeline& timeline) : timeline_(timeline) {}

  void set_size(const QSizeF& size) { size_ = size; }  // [pixels]
  [[nodiscard]] FrameScale scale() const { return {timeline_, 0.0, size_.width()}; }
  // `track`: its place among those shown.
  [[nodiscard]] QPointF position(double time, double value, std::size_t track) const;
  [[nodiscard]] double time_at(double x) const;  // [s]
  [[nodiscard]] double value_at(double y, std::size_t track) const;
  [[nodiscard]] double time_per_pixel() const;  // [s]
  [[nodiscard]] double value_per_pixel(std::size_t track) const;

  // Shows all values of the curves.
  void fit(const std::vector<Curve>& curves);
  void pan(double pixels);             // down
  void zoom(double y, double factor);  // of the values that are shown

  // Lines and numbers of the values of a track.
  void paint_values(QPainter& painter, const QWidget& widget, std::size_t track) const;

 private:
  struct Range {
    double low = -1.0;
    double high = 1.0;
  };
  [[nodiscard]] Range range(std::size_t track) const;

  const Timeline& timeline_;
  QSizeF size_{1.0, 1.0};
  std::vector<Range> ranges_;  // by track
};

}  // namespace brume
