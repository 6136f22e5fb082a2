#pragma once

#include <QRectF>
#include <QSizeF>
#include <vector>

#include "app/document/keyframe_curves.h"

class QPainter;
class QPalette;

namespace brume {

class Timeline;

// The part of the plane of times and values that a curve editor shows, above a ruler of frames.
class CurveAxes {
 public:
  static constexpr double ruler_height = 18.0;  // pixels

  void set_size(const QSizeF& size) { size_ = size; }  // [pixels], with the ruler
  [[nodiscard]] QPointF position(double time, double value) const;
  [[nodiscard]] double time_at(double x) const;  // [s]
  [[nodiscard]] double value_at(double y) const;
  [[nodiscard]] double time_per_pixel() const;  // [s]
  [[nodiscard]] double value_per_pixel() const;
  [[nodiscard]] bool is_on_ruler(const QPointF& at) const { return at.y() >= plot_height(); }

  // Shows the curves, and all frames of the timeline.
  void fit(const std::vector<Curve>& curves, const Timeline& timeline);
  void pan(const QPointF& pixels);
  void zoom(const QPointF& at, double in_time, double in_value);  // factors of what is shown

  void paint_grid(QPainter& painter, const QPalette& palette, const Timeline& timeline) const;

 private:
  [[nodiscard]] double plot_height() const { return std::max(1.0, size_.height() - ruler_height); }

  QSizeF size_{1.0, 1.0};
  QRectF shown_{0.0, -1.0, 1.0, 2.0};  // time [s] and value; bottom() is the greatest value
};

}  // namespace brume
