#pragma once

#include <QTimer>
#include <QWidget>
#include <array>

#include "app/commands/merge_id.h"
#include "app/document/gaussian_attribute.h"
#include "brume/edits.h"

namespace brume {

class Document;

// Histogram of an attribute with the selection marked; of albedo, emission or elongation, hidden
// while no Gaussian has any. Dragging selects a range; Shift adds, Ctrl removes. An edit costs what
// it changes, unless the range of values changes.
class GaussianHistogram : public QWidget {
  Q_OBJECT
 public:
  static constexpr int bins = 48;

  // A linear axis, or logarithmic for positive values of large range.
  struct Axis {
    double low = 0.0;
    double high = 0.0;
    bool logarithmic = false;

    Axis() = default;
    Axis(double least, double greatest);
    [[nodiscard]] double at(double position) const;     // value at a position in [0, 1]
    [[nodiscard]] double position(double value) const;  // inverse of at()
    [[nodiscard]] std::size_t bin(double value) const;  // of the histogram
  };

  GaussianHistogram(Document& document, GaussianAttribute field, QWidget* parent);

  [[nodiscard]] const Axis& axis() const;
  [[nodiscard]] QSize sizeHint() const override { return {120, 48}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  using Counts = std::array<std::size_t, bins>;

  void refresh();
  void follow(const MediumEdit& edit);
  // The value that a Gaussian of the shown medium has.
  [[nodiscard]] double value(std::size_t index) const;
  [[nodiscard]] double value(Gaussian gaussian) const;
  [[nodiscard]] bool has_any() const;  // Gaussians, and of them ones to show
  void count_all() const;
  [[nodiscard]] Counts selected_on(const Axis& axis) const;
  [[nodiscard]] QRect bars() const;
  void draw_axis(QPainter& painter, const QRect& line) const;
  void select_range(QPointF to);

  Document& document_;
  GaussianAttribute field_;
  glm::dvec3 shown_albedo_{0.0};  // of the medium
  // All Gaussians are counted on their axis, when that is needed.
  mutable bool is_counted_ = false;
  QTimer recount_timer_;  // of very many, once a gesture pauses
  mutable Axis axis_;
  mutable Counts all_{};
  // State of a drag.
  bool dragging_ = false;
  Axis drag_axis_;
  Counts drag_all_{};
  double start_ = 0.0;  // positions along the axis
  double end_ = 0.0;
  Qt::KeyboardModifiers modifiers_;
  std::vector<GaussianId> before_;
  MergeId merge_id_ = no_merge;
};

}  // namespace brume
