#pragma once

#include <QWidget>
#include <array>
#include <span>

#include "app/commands/merge_id.h"
#include "app/document/gaussian_attribute.h"

namespace brume {

class Document;

// Histogram of an attribute with the selection marked; of albedo or emission, hidden while no
// Gaussian has any. Dragging selects a range; Shift adds,
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

  GaussianHistogram(Document& document, GaussianAttribute field, QWidget* parent);

  [[nodiscard]] Axis axis() const { return Axis(values_); }
  [[nodiscard]] QSize sizeHint() const override { return {120, 48}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void refresh();
  [[nodiscard]] QRect bars() const;
  void select_range(QPointF to);

  Document& document_;
  GaussianAttribute field_;
  std::vector<double> values_;    // of all Gaussians
  glm::dvec3 shown_albedo_{0.0};  // of the medium
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
