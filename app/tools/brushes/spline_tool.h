#pragma once

#include "app/commands/merge_id.h"
#include "app/tools/brushes/paintbrush_tool.h"
#include "brume/painted_spline.h"
#include "core/scene/camera_rays.h"

namespace brume {

// Paints along the document's active spline, which stays editable: clicks add points, points can be
// dragged and removed, and a change of the brush repaints it, until New begins another. Each
// gesture is one undo step, of points and fog together.
class SplineTool : public PaintbrushTool {
  Q_OBJECT
 public:
  SplineTool(Document& document, View& view);

  // The one that is edited; without points if there is none.
  [[nodiscard]] const PaintedSpline& spline() const;
  // Leaves the spline as it is; the next click begins another.
  void finish();

  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;
  void hover(QPointF position) override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(std::span<const QPointF> path) override;
  void release(QPointF position) override;
  void cancel() override;
  void abandon() override;
  void draw(Overlay& overlay, const CameraRays& rays) const override;
  [[nodiscard]] bool draws_strokes() const override { return false; }

 private:
  [[nodiscard]] std::optional<std::size_t> pick(QPointF position) const;
  // Takes over the brush of the active spline.
  void adopt_brush();
  void forget_gesture();
  void begin_drag(QPointF position);
  // Paints along `points` in place of the present ones.
  void repaint(std::vector<glm::dvec3> points, const QString& text, MergeId merge_id);
  [[nodiscard]] std::vector<Gaussian> painted(const PaintedSpline& spline) const;

  std::optional<std::size_t> hovered_;
  std::optional<std::size_t> dragged_;  // point
  std::optional<StrokeDepth> dragged_depth_;
  std::vector<glm::dvec3> before_;  // the points when the drag began
  MergeId gesture_id_ = no_merge;
  MergeId options_id_ = no_merge;  // of changes of the brush in a row
  bool is_adopting_ = false;
  StrokeOptions mirrored_;  // that the spline's mirror images are of
};

}  // namespace brume
