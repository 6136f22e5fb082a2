#include "app/tools/emitter_tool.h"

#include <QLineF>
#include <glm/common.hpp>

#include "app/commands/objects/edit_emitters.h"
#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/tools/brushes/brush_cursor.h"
#include "app/tools/option_widgets.h"
#include "app/tools/selection/emitter_mark.h"
#include "app/view/drawing/gizmo.h"
#include "app/view/view.h"
#include "app/widgets/application.h"
#include "app/widgets/interface_settings.h"
#include "brume/limits.h"
#include "core/scene/camera_rays.h"

namespace brume {
namespace {

constexpr double pick_radius = 10.0;  // pixels

}  // namespace

QString EmitterTool::hint() const {
  return tr(
      "Click to place a particle emitter, drag to move one. Space plays; the panel Emitters has "
      "its settings.");
}

void EmitterTool::add_options(QHBoxLayout& row) {
  add_target(
      row, *this, "emitter", [this] { return target_; },
      [this](const PaintTarget& target) { set_target(target); });
}

void EmitterTool::set_target(const PaintTarget& target) {
  target_ = target;
  Q_EMIT options_changed();
}

std::optional<std::size_t> EmitterTool::pick(QPointF position) const {
  const CameraRays rays = view().rays();
  const Emitters& emitters = document_.scene().emitters;
  for (std::size_t k = 0; k < emitters.size(); ++k) {
    if (emitters[k].locked) continue;
    const glm::dvec3 projected = rays.project(emitters[k].position);
    if (projected.z > 0.0 && QLineF(QPointF(projected.x, projected.y), position).length() <=
                                 pick_radius * handle_scale())
      return k;
  }
  return std::nullopt;
}

void EmitterTool::hover(QPointF position) {
  cursor_ = position;
  hovered_ = pick(position);
  Q_EMIT appearance_changed();
}

void EmitterTool::leave() {
  cursor_.reset();
  hovered_.reset();
  Q_EMIT appearance_changed();
}

std::optional<PaintPoint> EmitterTool::paint_at(QPointF position) const {
  return paint_point(view(), target_, position, born_radius(view().distance()));
}

void EmitterTool::press(QPointF position, Qt::KeyboardModifiers /*modifiers*/) {
  if (const auto emitter = pick(position)) {
    document_.set_object(ObjectRef{ObjectRef::Kind::emitter, *emitter});
    drag_ = {*emitter, position, document_.scene().emitters[*emitter].position, new_merge_id()};
    return;
  }
  const auto point = paint_at(position);
  if (!point) return;
  add_emitter(document_, point->position, view().distance());
}

void EmitterTool::move(std::span<const QPointF> path) {
  if (drag_) drag_to(path.back());
}

void EmitterTool::drag_to(QPointF position) {
  glm::dvec3 place =
      drag_->before + dragged_across(drag_->before, view().rays(), drag_->start, position);
  if (position == drag_->start) place = drag_->before;
  place = glm::clamp(place, -limits::coordinate, limits::coordinate);
  change_emitter(document_, drag_->emitter, tr("Move %1"), drag_->merge_id,
                 [&](Emitter& emitter) { emitter.position = place; });
}

void EmitterTool::release(QPointF /*position*/) {
  drag_.reset();
}

void EmitterTool::cancel() {
  if (drag_) drag_to(drag_->start);
  drag_.reset();
}

// A mark shows what a click would put where the mouse is; and one each emitter that is there.
void EmitterTool::draw(Overlay& overlay, const CameraRays& rays) const {
  if (const auto point = cursor_ && !hovered_ && !drag_ ? paint_at(*cursor_) : std::nullopt) {
    const Gaussian born{point->position, born_radius(view().distance()), 1.0};
    add_brush_cursor(overlay, rays, view().surfaces(), born, point->normal);
    const Emitter asked = new_emitter(document_.scene(), point->position, view().distance());
    add_emitter_mark(overlay, rays, asked, qRgba(235, 238, 242, 130), true, 0.0);
  }
  const Emitters& emitters = document_.scene().emitters;
  for (std::size_t k = 0; k < emitters.size(); ++k) {
    const Emitter& emitter = emitters[k];
    const bool active = k == document_.active_emitter() || hovered_ == k;
    QColor color = active ? accent_color() : QColor(235, 238, 242);
    color.setAlpha(active ? 255 : 170);
    add_emitter_mark(overlay, rays, emitter, color.rgba(), active, view().time());
  }
}

}  // namespace brume
