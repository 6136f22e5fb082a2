#pragma once

#include "app/commands/objects/edit_objects.h"
#include "app/tools/selection/select_tool.h"
#include "app/view/drawing/gizmo.h"
#include "core/scene/camera_rays.h"

namespace brume {

// Base of transform tools: selection plus a manipulator at the center of the selected Gaussians, or
// of the light, emitter or surface that is selected. A soft selection takes Gaussians that are near
// along, the less the farther they are.
class TransformTool : public SelectTool {
  Q_OBJECT
 public:
  TransformTool(Gizmo::Kind kind, Document& document, View& view)
      : SelectTool(document, view), kind_(kind) {}

  // How far from the selection Gaussians are taken along [u]; 0: none.
  void set_soft_radius(double radius);

  void add_options(QHBoxLayout& row) override;
  void hover(QPointF position) override;
  void leave() override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(std::span<const QPointF> path) override;
  void release(QPointF position) override;
  void cancel() override;
  void abandon() override;
  void medium_changed() override;
  void draw(Overlay& overlay, const CameraRays& rays) const override;

 protected:
  // The movement of a drag from start_ to `position`.
  [[nodiscard]] virtual Movement dragged(QPointF position) const = 0;
  [[nodiscard]] virtual QString verb() const = 0;

  // The drag:
  Gizmo::Part part_ = Gizmo::Part::all;
  glm::dvec3 pivot_{0.0};
  QPointF start_;

 private:
  [[nodiscard]] bool has_something() const;
  void drag(QPointF position);

  Gizmo::Kind kind_;
  std::optional<Gizmo::Part> hovered_;
  bool dragging_ = false;
  bool applying_ = false;
  std::vector<GaussianId> ids_;
  std::vector<Gaussian> gaussians_;
  std::vector<double> weights_;  // 1 of selected ones
  double soft_radius_ = 0.0;
  std::optional<ObjectRef> ref_;  // instead of Gaussians
  std::optional<Object> object_;  // as it was
  MergeId merge_id_ = no_merge;
};

class MoveTool : public TransformTool {
  Q_OBJECT
 public:
  MoveTool(Document& document, View& view) : TransformTool(Gizmo::Kind::move, document, view) {}
  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;

 protected:
  [[nodiscard]] Movement dragged(QPointF position) const override;
  [[nodiscard]] QString verb() const override { return tr("Move %1"); }

 private:
  // Moves to the surface under the mouse if there is one, or to the nearest point of a grid through
  // the origin.
  enum class Snap { none, surface, grid };
  [[nodiscard]] glm::dvec3 way(QPointF position) const;  // of the pivot [u]

  Snap snap_ = Snap::none;
  double grid_ = 0.5;  // [u]
};

class RotateTool : public TransformTool {
  Q_OBJECT
 public:
  RotateTool(Document& document, View& view) : TransformTool(Gizmo::Kind::rotate, document, view) {}
  [[nodiscard]] QString hint() const override;

 protected:
  [[nodiscard]] Movement dragged(QPointF position) const override;
  [[nodiscard]] QString verb() const override { return tr("Rotate %1"); }
};

// Uniform scaling also scales radii and sizes; axis scaling moves centers, and stretches Gaussians
// and primitives.
class ScaleTool : public TransformTool {
  Q_OBJECT
 public:
  ScaleTool(Document& document, View& view) : TransformTool(Gizmo::Kind::scale, document, view) {}
  [[nodiscard]] QString hint() const override;

 protected:
  [[nodiscard]] Movement dragged(QPointF position) const override;
  [[nodiscard]] QString verb() const override { return tr("Scale %1"); }
};

}  // namespace brume
