#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/commands/merge_id.h"
#include "app/document/keyframe_curves.h"

namespace brume {

class Document;
class Timeline;

// The curves of a track: its numbers over time, with their keys as points. Drag a point in time and
// value; Delete deletes; right click opens a menu; double click adds a key; dragging elsewhere
// scrubs the timeline. The wheel zooms (Shift: time only, Ctrl: value only), the middle button
// pans, Home fits.
class CurveEditor : public QWidget {
  Q_OBJECT
 public:
  CurveEditor(Timeline& timeline, Document& document, QWidget* parent);

  // Shows a track; none: says how to make one.
  void set_track(const std::optional<Track>& row);
  void fit();

  [[nodiscard]] const std::vector<Curve>& curves() const { return curves_; }
  [[nodiscard]] QPointF position(double time, double value) const;
  [[nodiscard]] QSize sizeHint() const override { return {400, 180}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 80}; }

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Mark {
    std::size_t curve;
    double time;
  };
  void refresh();
  [[nodiscard]] double time_at(double x) const;
  [[nodiscard]] double value_of(double y) const;
  [[nodiscard]] int frame_near(double x) const;  // >= 0
  [[nodiscard]] std::optional<Mark> mark_near(QPointF position) const;
  void paint_grid(QPainter& painter) const;
  void paint_curve(QPainter& painter, std::size_t k) const;
  void delete_chosen();

  Timeline& timeline_;
  Document& document_;
  std::optional<Track> row_;
  std::vector<Curve> curves_;
  QRectF shown_{0.0, -1.0, 1.0, 2.0};  // time [s] and value; bottom() is the greatest value
  std::optional<Mark> chosen_;
  // A drag of a key: original part, original and current place.
  struct Drag {
    ScenePart before;
    double from;
    double value;  // at the start
    double to;
    QPointF press;
    MergeId gesture;
  };
  std::optional<Drag> drag_;
  std::optional<QPointF> pan_;
  bool scrubs_ = false;
};

}  // namespace brume
