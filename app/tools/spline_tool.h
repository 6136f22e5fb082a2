#pragma once

#include <memory>

#include "app/commands/spline_command.h"
#include "app/tools/paintbrush_tool.h"

namespace brume {

// Paints along a spline that stays editable: clicks add points, points can be dragged and removed,
// and a change of the brush repaints it, until New begins another. Each gesture is one undo step,
// of points and fog together. Only the fog is saved with a scene.
class SplineTool : public PaintbrushTool {
  Q_OBJECT
 public:
  SplineTool(Document& document, View& view);

  [[nodiscard]] const PaintedSpline& spline() const { return *spline_; }
  // Leaves the fog of the spline as it is; the next click begins another.
  void finish();

  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;
  void hover(QPointF position) override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(std::span<const QPointF> path) override;
  void release(QPointF position) override;
  void cancel() override;
  void abandon() override;
  void medium_changed() override;
  void draw(Overlay& overlay, const CameraRays& rays) const override;

 protected:
  void fit_to(double distance) override;

 private:
  [[nodiscard]] std::optional<std::size_t> pick(QPointF position) const;
  // Paints along `points` in place of the present ones.
  void repaint(std::vector<glm::dvec3> points, const QString& text, MergeId merge_id);
  [[nodiscard]] std::vector<Gaussian> painted(const PaintedSpline& spline);

  std::shared_ptr<PaintedSpline> spline_ = std::make_shared<PaintedSpline>();
  std::optional<std::size_t> hovered_;
  std::optional<std::size_t> dragged_;  // point
  std::vector<glm::dvec3> before_;      // the points when the drag began
  MergeId gesture_id_ = no_merge;
  MergeId options_id_ = no_merge;  // of changes of the brush in a row
};

}  // namespace brume
