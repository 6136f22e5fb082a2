#include "app/tools/selection/transform_tool.h"

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/commands/gaussians/edit_medium.h"
#include "app/document/document.h"
#include "app/tools/option_widgets.h"
#include "app/view/surface_picker.h"
#include "app/view/view.h"
#include "app/widgets/number_field.h"
#include "core/authoring/soft_selection.h"
#include "core/number_domain.h"
#include "core/scene/camera_rays.h"

namespace brume {
namespace {

// By a share of the movement, in [0, 1].
Gaussian moved(const Gaussian& gaussian, const Movement& movement, double share) {
  const glm::dquat still(1.0, 0.0, 0.0, 0.0);
  const glm::dvec3 stretch = glm::mix(glm::dvec3(1.0), movement.stretch, share);
  const glm::dquat turn = share == 1.0 ? movement.turn : glm::slerp(still, movement.turn, share);
  Gaussian result = gaussian;
  result.center = glm::mix(gaussian.center, movement.point(gaussian.center), share);
  if (stretch == glm::dvec3(stretch.x)) {  // exactly
    result.radius *= stretch.x;
  } else {
    transform(result, glm::dmat3(glm::scale(glm::dmat4(1.0), stretch)));
  }
  if (!result.is_ball() && turn != still) {
    result.shape.rotation = glm::normalize(turn * result.shape.rotation);
  }
  return result;
}

}  // namespace

bool TransformTool::has_something() const {
  return document_.object() || !document_.selection().empty();
}

void TransformTool::set_soft_radius(double radius) {
  soft_radius_ = radius;
  Q_EMIT options_changed();
  Q_EMIT appearance_changed();
}

void TransformTool::add_options(QHBoxLayout& row) {
  SelectTool::add_options(row);
  const char* const names[] = {"move_soft", "rotate_soft", "scale_soft"};
  ValueField* soft = add_number(
      row, *this,
      {tr("Soft"), names[static_cast<int>(kind_)], domain::not_negative, ValueField::Scale::linear,
       0.02},
      [this] { return soft_radius_; }, [this](double value) { set_soft_radius(value); });
  soft->number().show_length_unit();
  soft->setToolTip(
      tr("Soft selection: Gaussians within this distance of the selection, in scene "
         "units, come along, the less the farther they are; 0 is off"));
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
  gaussians_ = document_.gaussians(ids_);
  weights_.assign(ids_.size(), 1.0);
  if (soft_radius_ <= 0.0) return;
  for (const SoftMember& member : soft_members(medium, document_.selection(), soft_radius_)) {
    const GaussianId id = medium.ids()[member.index];
    if (!document_.is_editable(id)) continue;
    ids_.push_back(id);
    gaussians_.push_back(medium.gaussian(member.index));
    weights_.push_back(member.weight);
  }
}

void TransformTool::drag(QPointF position) {
  const Movement movement = position == start_ ? Movement{.pivot = pivot_} : dragged(position);
  if (object_ && document_.object() != ref_) return;  // deleted meanwhile
  if (object_) return move_object(document_, *ref_, *object_, movement, verb(), merge_id_);
  std::vector<Gaussian> after = gaussians_;
  if (position != start_) {
    for (std::size_t k = 0; k < after.size(); ++k) {
      after[k] = moved(after[k], movement, weights_[k]);
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
  if (soft_radius_ > 0.0 && !document_.object()) {
    overlay.add_outline(rays, {.center = view().pivot(), .radius = soft_radius_},
                        qRgba(235, 238, 242, 90));
  }
  const auto active = dragging_ ? std::optional(part_) : hovered_;
  Gizmo(kind_, view().pivot(), rays).draw(overlay, active);
}

QString MoveTool::hint() const {
  return tr("Drag an arrow to move the selection along it, the ring to move it in the view plane.");
}

void MoveTool::add_options(QHBoxLayout& row) {
  TransformTool::add_options(row);
  add_choice(
      row, *this, {tr("Snap to"), "move_snap"}, {tr("Nothing"), tr("Surface"), tr("Grid")},
      [this] { return static_cast<int>(snap_); },
      [this](int index) {
        snap_ = static_cast<Snap>(index);
        Q_EMIT options_changed();
      });
  ValueField* grid = add_number(
      row, *this, {tr("Grid"), "move_grid", domain::length, ValueField::Scale::logarithmic, 0.01},
      [this] { return grid_; },
      [this](double value) {
        grid_ = value;
        Q_EMIT options_changed();
      });
  grid->number().show_length_unit();
  grid->setToolTip(tr("Distance between the points of the grid in scene units"));
  const auto show = [this, grid] { grid->setEnabled(snap_ == Snap::grid); };
  connect(this, &Tool::options_changed, grid, show);
  show();
}

glm::dvec3 MoveTool::way(QPointF position) const {
  const CameraRays rays = view().rays();
  const bool in_view_plane = part_ == Gizmo::Part::all;
  if (snap_ == Snap::surface && in_view_plane) {
    const glm::dvec3 direction = rays.direction(position.x(), position.y());
    const auto hit =
        view().surfaces().hit_in_view(rays, rays.origin(position.x(), position.y()), direction);
    // A surface would climb up itself.
    const auto& object = document_.object();
    const bool is_itself = hit && object && object->kind == ObjectRef::Kind::surface &&
                           object->index == view().surfaces().index_of(*hit);
    if (hit && !is_itself) return hit->position - pivot_;
  }
  const glm::dvec3 axis = axis_of(part_);
  const glm::dvec3 way = in_view_plane ? dragged_across(pivot_, rays, start_, position)
                                       : axis * dragged_along(pivot_, axis, rays, start_, position);
  if (snap_ != Snap::grid) return way;
  const glm::dvec3 snapped = glm::round((pivot_ + way) / grid_) * grid_ - pivot_;
  return in_view_plane ? snapped : axis * glm::dot(axis, snapped);
}

Movement MoveTool::dragged(QPointF position) const {
  return {.pivot = pivot_, .shift = way(position)};
}

QString RotateTool::hint() const {
  return tr(
      "Drag a ring to rotate the selection about its axis, the outer ring about the view "
      "direction.");
}

Movement RotateTool::dragged(QPointF position) const {
  const CameraRays rays = view().rays();
  const glm::dvec3 axis = part_ == Gizmo::Part::all ? rays.towards(pivot_) : axis_of(part_);
  const double angle = dragged_around(pivot_, axis, rays, start_, position);
  return {.pivot = pivot_, .turn = glm::angleAxis(angle, axis)};
}

QString ScaleTool::hint() const {
  return tr(
      "Drag the ring to scale the selection uniformly, radii included; drag an axis to stretch "
      "it: balls become ellipsoids.");
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
