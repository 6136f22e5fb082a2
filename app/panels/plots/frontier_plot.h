#pragma once

#include <QWidget>
#include <vector>

#include "render/quality/error_estimate.h"
#include "render/settings.h"

namespace brume {

class FrameQuality;

// Plot of time against error in the current scene on logarithmic axes: measured settings with
// confidence intervals; marks the current settings, auto's choice and its bound.
class FrontierPlot : public QWidget {
  Q_OBJECT
 public:
  struct Point {
    Settings settings;
    ErrorEstimate error;
    double milliseconds = 0.0;  // of a frame, > 0
    bool is_shown = false;
    bool is_auto_choice = false;
  };

  explicit FrontierPlot(QWidget* parent = nullptr);

  void show_quality(const FrameQuality& quality);
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  // Widget position of a point.
  [[nodiscard]] QPointF position(const Point& point) const;
  // Tick labels of the error axis.
  struct Label {
    QRectF place;
    QString text;
  };
  [[nodiscard]] std::vector<Label> error_labels() const;
  void show_points(std::vector<Point> points, double max_error);

  [[nodiscard]] QSize minimumSizeHint() const override { return {110, 90}; }
  [[nodiscard]] QSize sizeHint() const override { return {160, 110}; }

 protected:
  bool event(QEvent* event) override;  // tool tip of the point under the mouse
  void paintEvent(QPaintEvent* event) override;

 private:
  // An axis in powers of ten.
  struct Range {
    double low = 1.0;
    double high = 10.0;
    [[nodiscard]] double position(double value) const;  // in [0, 1]
  };
  [[nodiscard]] QRectF area() const;
  // Labelled ticks of the error axis that fit.
  [[nodiscard]] std::vector<double> labelled_errors(double height) const;
  [[nodiscard]] double height_of(double error) const;

  std::vector<Point> points_;
  double max_error_ = Settings{}.max_error;
  Range milliseconds_;
  Range errors_;
};

}  // namespace brume
