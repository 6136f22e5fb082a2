#include "app/tools/transform_tool.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/commands/edit_medium.h"
#include "app/document/document.h"
#include "app/view/view.h"

namespace brume {

bool TransformTool::has_something() const {
  return document_.object() || !document_.selection().empty();
}

void TransformTool::hover(QPointF position) {
  hovered_.reset();
  if (has_something()) {
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
  gaussians_.clear();
  ref_ = document_.object();
  object_ = ref_ ? object_of(document_.scene(), *ref_) : std::nullopt;
  if (object_) return;
  ids_ = document_.selection();
  const Medium& medium = document_.medium();
  for (const GaussianId id : ids_) gaussians_.push_back(medium.gaussian(*medium.index_of(id)));
}

void TransformTool::drag(QPointF position) {
  const Movement movement = position == start_ ? Movement{.pivot = pivot_} : dragged(position);
  if (object_ && document_.object() != ref_) return;  // deleted meanwhile
  if (object_) return move_object(document_, *ref_, *object_, movement, verb(), merge_id_);
  std::vector<Gaussian> after = gaussians_;
  if (position != start_) {
    for (Gaussian& gaussian : after) {
      gaussian.center = movement.point(gaussian.center);
      gaussian.radius *= movement.size;
    }
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
  if (!has_something()) return;
  const auto active = dragging_ ? std::optional(part_) : hovered_;
  Gizmo(kind_, view().pivot(), rays).draw(overlay, active);
}

QString MoveTool::hint() const {
  return tr("Drag an arrow to move the selection along it, the ring to move it in the view plane.");
}

Movement MoveTool::dragged(QPointF position) const {
  const CameraRays rays = view().rays();
  const glm::dvec3 axis = axis_of(part_);
  return {.pivot = pivot_,
          .shift = part_ == Gizmo::Part::all
                       ? dragged_across(pivot_, rays, start_, position)
                       : axis * dragged_along(pivot_, axis, rays, start_, position)};
}

QString RotateTool::hint() const {
  return tr(
      "Drag a ring to rotate the selection about its axis, the outer ring about the view "
      "direction.");
}

Movement RotateTool::dragged(QPointF position) const {
  const CameraRays rays = view().rays();
  const glm::dvec3 axis =
      part_ == Gizmo::Part::all ? glm::normalize(pivot_ - rays.eye()) : axis_of(part_);
  const double angle = dragged_around(pivot_, axis, rays, start_, position);
  return {.pivot = pivot_, .turn = glm::angleAxis(angle, axis)};
}

QString ScaleTool::hint() const {
  return tr(
      "Drag the ring to scale the selection uniformly, radii included; drag an axis to stretch "
      "it.");
}

Movement ScaleTool::dragged(QPointF position) const {
  const double factor = dragged_away(pivot_, view().rays(), start_, position);
  Movement movement{.pivot = pivot_};
  if (part_ == Gizmo::Part::all) {
    movement.stretch = glm::dvec3(factor);
    movement.size = factor;
  } else {
    movement.stretch[static_cast<int>(part_)] = factor;
  }
  return movement;
}

}  // namespace brume
