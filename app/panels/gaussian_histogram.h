#pragma once

#include <QWidget>
#include <array>
#include <span>

#include "app/commands/merge_id.h"
#include "app/document/gaussian_attribute.h"

namespace brume {

class Document;

// Histogram of radius or density with the selection marked. Dragging selects a range; Shift adds,
// Ctrl removes.
class GaussianHistogram : public QWidget {
  Q_OBJECT
 public:
  static constexpr int bins = 48;

  // A linear axis, or logarithmic for positive values of large range.
  struct Axis {
    double low = 0.0;
    double high = 0.0;
    bool logarithmic = false;

    explicit Axis(std::span<const double> values = {});
    [[nodiscard]] double at(double position) const;     // value at a position in [0, 1]
    [[nodiscard]] double position(double value) const;  // inverse of at()
  };

  // `field`: radius or density.
  GaussianHistogram(Document& document, GaussianAttribute field, QWidget* parent);

  [[nodiscard]] Axis axis() const { return Axis(values()); }
  [[nodiscard]] QSize sizeHint() const override { return {120, 58}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] std::span<const double> values() const;
  [[nodiscard]] QRect bars() const;
  void select_range(QPointF to);

  Document& document_;
  GaussianAttribute field_;
  // State of a drag.
  bool dragging_ = false;
  Axis drag_axis_;
  double start_ = 0.0;  // positions along the axis
  double end_ = 0.0;
  Qt::KeyboardModifiers modifiers_;
  std::vector<GaussianId> before_;
  MergeId merge_id_ = no_merge;
};

}  // namespace brume
