#pragma once

#include <QPolygonF>

#include "app/tools/selection/selection_tool.h"
#include "app/tools/stroke_path.h"

namespace brume {

// Selects Gaussians whose center is inside a drawn line.
class LassoTool : public SelectionTool {
  Q_OBJECT
 public:
  using SelectionTool::SelectionTool;

  [[nodiscard]] QString hint() const override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(std::span<const QPointF> path) override;
  void release(QPointF position) override;
  void cancel() override { abandon(); }
  void abandon() override;
  void draw_on_film(Overlay& overlay) const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

 private:
  void extend(const std::vector<QPointF>& curve);

  QPolygonF line_;  // empty: no gesture
  StrokePath path_;
  QPointF cursor_;  // the line's end, beyond the smoothed part
  SelectMode gesture_mode_ = SelectMode::set;
};

}  // namespace brume
