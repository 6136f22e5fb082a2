#pragma once

#include <optional>

#include "app/tools/selection/selection_tool.h"
#include "app/tools/stroke_path.h"

namespace brume {

// Selects Gaussians whose center a circular brush passes over.
class BrushSelectTool : public SelectionTool {
  Q_OBJECT
 public:
  using SelectionTool::SelectionTool;

  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;
  void hover(QPointF position) override;
  void leave() override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(std::span<const QPointF> path) override;
  void release(QPointF position) override;
  void cancel() override;
  void abandon() override { running_ = false; }
  void medium_changed() override { running_ = false; }
  void draw_on_film(Overlay& overlay) const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  [[nodiscard]] bool draws_strokes() const override { return true; }
  void change_size(double factor) override { set_radius(radius_ * factor); }

 private:
  void set_radius(double radius);
  void pass(const std::vector<QPointF>& curve);

  double radius_ = 30.0;  // pixels
  std::optional<QPointF> cursor_;
  // State of a gesture.
  bool running_ = false;
  SelectMode gesture_mode_ = SelectMode::set;
  MergeId merge_id_ = no_merge;
  std::vector<GaussianId> before_;
  std::vector<std::size_t> passed_;
  StrokePath path_;
  QPointF last_;
};

}  // namespace brume
