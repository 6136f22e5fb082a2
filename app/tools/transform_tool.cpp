#include "app/tools/transform_tool.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/commands/edit_medium.h"
#include "app/document/document.h"
#include "app/view/view.h"

namespace brume {

void TransformTool::hover(QPointF position) {
  hovered_.reset();
  if (!document_.selection().empty()) {
    hovered_ = Gizmo(kind_, view().pivot(), view().rays()).pick(position);
  }
  Q_EMIT appearance_changed();
  if (hovered_) {
    view().set_hovered(std::nullopt);
  } else {
    SelectTool::hover(position);
  }
}

void TransformTool::leave() {
  hovered_.reset();
  SelectTool::leave();
}

void TransformTool::press(QPointF position, Qt::KeyboardModifiers modifiers) {
  hover(position);
  if (!hovered_) {
    SelectTool::press(position, modifiers);
    return;
  }
  dragging_ = true;
  part_ = *hovered_;
  pivot_ = view().pivot();
  start_ = position;
  merge_id_ = new_merge_id();
  ids_ = document_.selection();
  gaussians_.clear();
  const Medium& medium = document_.medium();
  for (const GaussianId id : ids_) gaussians_.push_back(medium.gaussian(*medium.index_of(id)));
}

void TransformTool::drag(QPointF position) {
  std::vector<Gaussian> after;
  after.reserve(gaussians_.size());
  for (const Gaussian& gaussian : gaussians_) {
    after.push_back(position == start_ ? gaussian : dragged(gaussian, position));
  }
  applying_ = true;
  change_gaussians(document_, ids_, after, verb().arg(gaussians_text(ids_.size())), merge_id_);
  applying_ = false;
}

void TransformTool::move(std::span<const QPointF> path) {
  if (dragging_) {
    drag(path.back());
  } else {
    SelectTool::move(path);
  }
}

void TransformTool::release(QPointF position) {
  if (!dragging_) SelectTool::release(position);
  dragging_ = false;
}

void TransformTool::cancel() {
  if (dragging_) {
    drag(start_);
    dragging_ = false;
  } else {
    SelectTool::cancel();
  }
}

void TransformTool::abandon() {
  dragging_ = false;
  SelectTool::abandon();
}

void TransformTool::medium_changed() {
  // Other changes of the medium end the drag, whose original values are stale.
  if (!applying_) dragging_ = false;
  SelectTool::medium_changed();
}

void TransformTool::draw(Overlay& overlay, const CameraRays& rays) const {
  SelectTool::draw(overlay, rays);
  if (document_.selection().empty()) return;
  const auto active = dragging_ ? std::optional(part_) : hovered_;
  Gizmo(kind_, view().pivot(), rays).draw(overlay, active);
}

QString MoveTool::hint() const {
  return tr("Drag an arrow to move the selection along it, the ring to move it in the view plane.");
}

Gaussian MoveTool::dragged(const Gaussian& gaussian, QPointF position) const {
  const CameraRays rays = view().rays();
  const glm::dvec3 axis = axis_of(part_);
  Gaussian moved = gaussian;
  moved.center += part_ == Gizmo::Part::all
                      ? dragged_across(pivot_, rays, start_, position)
                      : axis * dragged_along(pivot_, axis, rays, start_, position);
  return moved;
}

QString RotateTool::hint() const {
  return tr(
      "Drag a ring to rotate the selection about its axis, the outer ring about the view "
      "direction.");
}

Gaussian RotateTool::dragged(const Gaussian& gaussian, QPointF position) const {
  const CameraRays rays = view().rays();
  const glm::dvec3 axis =
      part_ == Gizmo::Part::all ? glm::normalize(pivot_ - rays.eye()) : axis_of(part_);
  const double angle = dragged_around(pivot_, axis, rays, start_, position);
  Gaussian turned = gaussian;
  turned.center = pivot_ + glm::angleAxis(angle, axis) * (gaussian.center - pivot_);
  return turned;
}

QString ScaleTool::hint() const {
  return tr(
      "Drag the ring to scale the selection uniformly, radii included; drag an axis to stretch "
      "it.");
}

Gaussian ScaleTool::dragged(const Gaussian& gaussian, QPointF position) const {
  const double factor = dragged_away(pivot_, view().rays(), start_, position);
  Gaussian scaled = gaussian;
  if (part_ == Gizmo::Part::all) {
    scaled.center = pivot_ + factor * (gaussian.center - pivot_);
    scaled.radius *= factor;
  } else {
    const int k = static_cast<int>(part_);
    scaled.center[k] = pivot_[k] + factor * (gaussian.center[k] - pivot_[k]);
  }
  return scaled;
}

}  // namespace brume
