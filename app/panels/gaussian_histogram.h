#pragma once

#include <QWidget>
#include <array>
#include <span>

#include "app/commands/merge_id.h"
#include "app/document/gaussian_field.h"

namespace brume {

class Document;

// How many Gaussians have what radius or density, with the selected ones marked. A drag selects
// those in a range: Shift adds them, Ctrl takes them away.
class GaussianHistogram : public QWidget {
  Q_OBJECT
 public:
  static constexpr int bins = 48;

  // Evenly divided numbers, or by equal factors where all are positive and far apart.
  struct Axis {
    double low = 0.0;
    double high = 0.0;
    bool logarithmic = false;

    explicit Axis(std::span<const double> values = {});
    [[nodiscard]] double at(double position) const;     // of a position in [0, 1]
    [[nodiscard]] double position(double value) const;  // of a value of the axis
  };

  // `field`: radius or density.
  GaussianHistogram(Document& document, GaussianField field, QWidget* parent);

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
  GaussianField field_;
  // Of the drag.
  bool dragging_ = false;
  Axis drag_axis_;
  double from_ = 0.0;  // positions along the axis
  double to_ = 0.0;
  Qt::KeyboardModifiers modifiers_;
  std::vector<GaussianId> before_;
  MergeId merge_id_ = no_merge;
};

}  // namespace brume
