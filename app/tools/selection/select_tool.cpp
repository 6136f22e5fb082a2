#include "app/tools/selection/select_tool.h"
#include "core/scene/camera_rays.h"

#include <QRectF>
#include <algorithm>
#include <glm/geometric.hpp>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/tools/selection/click_target.h"
#include "app/tools/selection/emitter_mark.h"
#include "app/view/camera/object_box.h"
#include "app/view/view.h"
#include "app/widgets/interface_settings.h"

namespace brume {
namespace {

constexpr QRgb emitter_color = qRgba(150, 200, 240, 170);
constexpr QRgb object_color = qRgba(255, 190, 90, 235);
constexpr QRgb hovered_color = qRgba(255, 235, 200, 110);

}  // namespace

QString SelectTool::hint() const {
  return tr(
      "Click to select Gaussians, surfaces, lights; drag a selected handle to move the selection, "
      "drag elsewhere to box select. Middle button orbits, wheel zooms.");
}

void SelectTool::hover(QPointF position) {
  const auto before = lights_.hovered();
  const bool was_on_sun = sun_.is_hovered();
  const bool on_sun = sun_.hover(view().rays(), position);
  const bool on_light = lights_.hover(view().rays(), position) || on_sun;
  if (lights_.hovered() != before || on_sun != was_on_sun) Q_EMIT appearance_changed();
  const ClickTarget target = on_light ? ClickTarget{} : click_target(document_, view(), position);
  set_hovered_object(target.object);
  view().set_hovered(target.gaussian);
}

void SelectTool::set_hovered_object(const std::optional<ObjectRef>& object) {
  if (object == hovered_object_) return;
  hovered_object_ = object;
  Q_EMIT appearance_changed();
}

void SelectTool::leave() {
  set_hovered_object(std::nullopt);
  view().set_hovered(std::nullopt);
}

void SelectTool::press(QPointF position, Qt::KeyboardModifiers modifiers) {
  if (lights_.press(view().rays(), position) || sun_.press(view().rays(), position)) return;
  start_ = position;
  gesture_ = Gesture::undecided;
  area_mode_ = click_mode_ = mode_with(modifiers);
  if (click_mode_ == SelectMode::remove && mode() != SelectMode::remove) {
    click_mode_ = SelectMode::toggle;
  }
  pressed_.reset();
  if (const auto index = view().handles().pick(position)) {
    pressed_ = document_.medium().ids()[*index];
  }
}

void SelectTool::move(std::span<const QPointF> path) {
  const QPointF position = path.back();
  if (lights_.is_dragging()) {
    lights_.move(view().rays(), position);
    return;
  }
  if (sun_.is_dragging()) {
    sun_.move(view().rays(), position);
    return;
  }
  if (gesture_ == Gesture::undecided) {
    // In dense fog there is a handle under most places: nothing moves that was not selected.
    if (pressed_ && document_.is_selected(*pressed_)) {
      begin_move();
    } else {
      gesture_ = Gesture::band;
    }
  }
  if (gesture_ == Gesture::band) {
    view().show_band(QRectF(start_, position).normalized().toAlignedRect());
  } else if (gesture_ == Gesture::moving) {
    move_selection(position);
  }
}

void SelectTool::release(QPointF position) {
  const Medium& medium = document_.medium();
  if (gesture_ == Gesture::band) {
    const QRectF band = QRectF(start_, position).normalized();
    choose(document_.selection(),
           view().handles().inside([&band](QPointF at) { return band.contains(at); }), area_mode_);
  } else if (gesture_ == Gesture::undecided) {
    const ClickTarget target =
        pressed_ ? ClickTarget{pressed_, std::nullopt} : click_target(document_, view(), position);
    const auto& clicked = target.gaussian;
    choose(document_.selection(),
           clicked ? std::vector{*medium.index_of(*clicked)} : std::vector<std::size_t>{},
           click_mode_);
    document_.set_object(target.object);
  }
  abandon();
}

void SelectTool::cancel() {
  if (lights_.is_dragging()) lights_.cancel();
  if (sun_.is_dragging()) sun_.cancel();
  if (gesture_ == Gesture::moving) move_selection(start_);
  abandon();
}

void SelectTool::abandon() {
  view().show_band({});
  lights_.end();
  sun_.end();
  gesture_ = Gesture::none;
  pressed_.reset();
}

void SelectTool::draw(Overlay& overlay, const CameraRays& rays) const {
  lights_.draw(overlay, rays);
  sun_.draw(overlay, rays);
  const Scene& scene = document_.scene();
  for (std::size_t k = 0; k < scene.emitters.size(); ++k) {
    const bool is_chosen = document_.object() == ObjectRef{ObjectRef::Kind::emitter, k};
    add_emitter_mark(overlay, rays, scene.emitters[k], is_chosen ? object_color : emitter_color,
                     is_chosen, view().time());
  }
  const auto& object = document_.object();
  if (object) add_object_outline(overlay, rays, scene, *object, object_color);
  if (hovered_object_ && hovered_object_ != object && object_of(scene, *hovered_object_)) {
    add_object_outline(overlay, rays, scene, *hovered_object_, hovered_color);
  }
}

void SelectTool::medium_changed() {
  // Undo works during a drag too, and may take from the medium what is being dragged.
  const bool pressed_is_gone = pressed_ && !document_.medium().index_of(*pressed_);
  if (pressed_is_gone || (gesture_ == Gesture::moving && !has_moved_gaussians())) abandon();
}

void SelectTool::begin_move() {
  gesture_ = Gesture::moving;
  merge_id_ = new_merge_id();
  ids_ = document_.selection();
  gaussians_ = document_.gaussians(ids_);
  depth_ = view().handles().position(*document_.medium().index_of(*pressed_)).z;
}

void SelectTool::move_selection(QPointF position) {
  const glm::dvec3 shift = on_drag_plane(position) - on_drag_plane(start_);
  std::vector<Gaussian> moved = gaussians_;
  for (Gaussian& gaussian : moved) gaussian.center += shift;
  change_gaussians(document_, ids_, moved, tr("Move %1").arg(gaussians_text(ids_.size())),
                   merge_id_);
}

bool SelectTool::has_moved_gaussians() const {
  return std::all_of(ids_.begin(), ids_.end(),
                     [this](GaussianId id) { return document_.medium().index_of(id); });
}

glm::dvec3 SelectTool::on_drag_plane(QPointF position) const {
  const CameraRays rays = view().rays();
  const glm::dvec3 direction = rays.direction(position.x(), position.y());
  return rays.origin(position.x(), position.y()) +
         direction * (depth_ / glm::dot(direction, rays.forward()));
}

}  // namespace brume
