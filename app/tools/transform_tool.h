#pragma once

#include "app/tools/gizmo.h"
#include "app/tools/select_tool.h"

namespace brume {

// A select tool with handles around the middle of the selection.
class TransformTool : public SelectTool {
  Q_OBJECT
 public:
  TransformTool(Gizmo::Kind kind, Document& document, Viewport& viewport)
      : SelectTool(document, viewport), kind_(kind) {}

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
  // A Gaussian after a drag of a part of the handles from start_ to `position`.
  [[nodiscard]] virtual Gaussian dragged(const Gaussian& gaussian, QPointF position) const = 0;
  [[nodiscard]] virtual QString verb() const = 0;

  // Of the drag.
  Gizmo::Part part_ = Gizmo::Part::all;
  glm::dvec3 pivot_{0.0};
  QPointF start_;

 private:
  void drag(QPointF position);

  Gizmo::Kind kind_;
  std::optional<Gizmo::Part> hovered_;
  bool dragging_ = false;
  bool applying_ = false;
  std::vector<GaussianId> ids_;
  std::vector<Gaussian> gaussians_;
  MergeId merge_id_ = no_merge;
};

class MoveTool : public TransformTool {
  Q_OBJECT
 public:
  MoveTool(Document& document, Viewport& viewport)
      : TransformTool(Gizmo::Kind::move, document, viewport) {}
  [[nodiscard]] QString hint() const override;

 protected:
  [[nodiscard]] Gaussian dragged(const Gaussian& gaussian, QPointF position) const override;
  [[nodiscard]] QString verb() const override { return tr("Move %1"); }
};

class RotateTool : public TransformTool {
  Q_OBJECT
 public:
  RotateTool(Document& document, Viewport& viewport)
      : TransformTool(Gizmo::Kind::rotate, document, viewport) {}
  [[nodiscard]] QString hint() const override;

 protected:
  [[nodiscard]] Gaussian dragged(const Gaussian& gaussian, QPointF position) const override;
  [[nodiscard]] QString verb() const override { return tr("Rotate %1"); }
};

// Scaling alike scales the radii too; scaling along an axis only moves the centres.
class ScaleTool : public TransformTool {
  Q_OBJECT
 public:
  ScaleTool(Document& document, Viewport& viewport)
      : TransformTool(Gizmo::Kind::scale, document, viewport) {}
  [[nodiscard]] QString hint() const override;

 protected:
  [[nodiscard]] Gaussian dragged(const Gaussian& gaussian, QPointF position) const override;
  [[nodiscard]] QString verb() const override { return tr("Scale %1"); }
};

}  // namespace brume
