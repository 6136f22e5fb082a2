#include "app/tools/select_tool.h"

#include <QLineF>
#include <QRectF>
#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>

#include "app/commands/edit_medium.h"
#include "app/document/document.h"
#include "app/viewport/viewport.h"

namespace brume {
namespace {

constexpr double drag_threshold = 4.0;  // pixels; a hand is not perfectly still in a click

}  // namespace

QString SelectTool::hint() const {
  return tr(
      "Click selects, drag moves the selection. Middle button orbits, with Shift pans, wheel "
      "zooms.");
}

void SelectTool::hover(QPointF position) {
  const auto index = viewport_.handles().pick(position);
  viewport_.set_hovered(index ? std::optional(document_.medium().ids()[*index]) : std::nullopt);
}

void SelectTool::leave() {
  viewport_.set_hovered(std::nullopt);
}

void SelectTool::press(QPointF position, Qt::KeyboardModifiers modifiers) {
  start_ = position;
  gesture_ = Gesture::undecided;
  mode_ = modifiers.testFlag(Qt::ControlModifier) ? Mode::toggle
          : modifiers.testFlag(Qt::ShiftModifier) ? Mode::add
                                                  : Mode::replace;
  pressed_.reset();
  if (const auto index = viewport_.handles().pick(position)) {
    pressed_ = document_.medium().ids()[*index];
    // At once, so that press and drag in one go moves it. One that is selected already waits for
    // the release: the drag may be meant for the whole selection.
    if (mode_ != Mode::replace || !document_.is_selected(*pressed_)) select({*pressed_}, mode_);
  }
}

void SelectTool::move(QPointF position) {
  if (gesture_ == Gesture::undecided && QLineF(start_, position).length() >= drag_threshold) {
    if (!pressed_) {
      gesture_ = Gesture::band;
    } else if (document_.is_selected(*pressed_)) {
      begin_move();
    }
  }
  if (gesture_ == Gesture::band) {
    viewport_.show_band(QRectF(start_, position).normalized().toAlignedRect());
  } else if (gesture_ == Gesture::moving) {
    move_selection(position);
  }
}

void SelectTool::release(QPointF position) {
  if (gesture_ == Gesture::band) {
    std::vector<GaussianId> ids;
    for (const std::size_t index :
         viewport_.handles().inside(QRectF(start_, position).normalized())) {
      ids.push_back(document_.medium().ids()[index]);
    }
    select(ids, mode_);
  } else if (gesture_ == Gesture::undecided && mode_ == Mode::replace) {
    select(pressed_ ? std::vector{*pressed_} : std::vector<GaussianId>{}, Mode::replace);
  }
  abandon();
}

void SelectTool::cancel() {
  if (gesture_ == Gesture::moving) move_selection(start_);
  abandon();
}

void SelectTool::abandon() {
  viewport_.show_band({});
  gesture_ = Gesture::none;
  pressed_.reset();
}

void SelectTool::medium_changed() {
  // Undo works during a drag too, and may take from the medium what is being dragged.
  const bool pressed_is_gone = pressed_ && !document_.medium().index_of(*pressed_);
  if (pressed_is_gone || (gesture_ == Gesture::moving && !moved_are_there())) abandon();
}

void SelectTool::select(const std::vector<GaussianId>& ids, Mode mode) {
  const std::vector<GaussianId>& old = document_.selection();
  std::vector<GaussianId> selection;
  if (mode == Mode::replace) {
    selection = ids;
  } else if (mode == Mode::add) {
    std::set_union(old.begin(), old.end(), ids.begin(), ids.end(), std::back_inserter(selection));
  } else {
    std::set_symmetric_difference(old.begin(), old.end(), ids.begin(), ids.end(),
                                  std::back_inserter(selection));
  }
  document_.select(std::move(selection));
}

void SelectTool::begin_move() {
  const Medium& medium = document_.medium();
  gesture_ = Gesture::moving;
  merge_id_ = new_merge_id();
  ids_ = document_.selection();
  centers_.clear();
  for (const GaussianId id : ids_) centers_.push_back(medium.centers()[*medium.index_of(id)]);
  depth_ = viewport_.handles().position(*medium.index_of(*pressed_)).z;
}

void SelectTool::move_selection(QPointF position) {
  const glm::dvec3 shift = on_drag_plane(position) - on_drag_plane(start_);
  std::vector<glm::dvec3> centers = centers_;
  for (glm::dvec3& center : centers) center += shift;
  move_gaussians(document_, ids_, centers, merge_id_);
}

bool SelectTool::moved_are_there() const {
  return std::all_of(ids_.begin(), ids_.end(),
                     [this](GaussianId id) { return document_.medium().index_of(id); });
}

glm::dvec3 SelectTool::on_drag_plane(QPointF position) const {
  const CameraRays rays = viewport_.rays();
  const glm::dvec3 direction = rays.direction(position.x(), position.y());
  return rays.eye() + direction * (depth_ / glm::dot(direction, rays.forward()));
}

}  // namespace brume
