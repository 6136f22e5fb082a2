#pragma once

#include <QPolygonF>

#include "app/tools/selection_tool.h"

namespace brume {

// Selects the Gaussians whose centre is inside a line drawn around them.
class LassoTool : public SelectionTool {
  Q_OBJECT
 public:
  using SelectionTool::SelectionTool;

  [[nodiscard]] QString hint() const override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(QPointF position) override;
  void release(QPointF position) override;
  void cancel() override { abandon(); }
  void abandon() override;
  void draw_on_film(Overlay& overlay) const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

 private:
  QPolygonF line_;  // empty: no gesture
  SelectMode gesture_mode_ = SelectMode::set;
};

}  // namespace brume
