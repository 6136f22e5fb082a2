#include "app/panels/time/key_menu.h"

#include <QCoreApplication>
#include <QMenu>
#include <algorithm>
#include <cmath>

#include "app/commands/objects/edit_keys.h"
#include "app/document/document.h"
#include "app/document/time/timeline.h"

namespace brume {
namespace {

QString menu_text(const char* text) {
  return QCoreApplication::translate("KeyMenu", text);
}

Keyframe keyframe_at(const Scene& scene, const Track& row, double time) {
  for (const Keyframe& mark : keyframes_of(scene, row)) {
    if (is_same_key_time(mark.time, time)) return mark;
  }
  return {};
}

}  // namespace

void show_key_menu(QWidget& owner, Document& document, const std::vector<TrackKeys>& keys,
                   const Track& track, double time, const std::vector<KeyAction>& actions,
                   const QPoint& global_position) {
  const Keyframe now = keyframe_at(document.scene(), track, time);
  auto* menu = new QMenu(&owner);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, bool is_now, auto&& run) {
    QAction* action = menu->addAction(text, &owner, run);
    action->setCheckable(true);
    action->setChecked(is_now);
  };
  const auto add_interpolation = [&](const char* text, Interpolation interpolation) {
    add(menu_text(text), now.interpolation == interpolation,
        [&document, keys, interpolation] { set_interpolation(document, keys, interpolation); });
  };
  add_interpolation(QT_TRANSLATE_NOOP("KeyMenu", "&Smooth"), Interpolation::smooth);
  add_interpolation(QT_TRANSLATE_NOOP("KeyMenu", "&Linear"), Interpolation::linear);
  add_interpolation(QT_TRANSLATE_NOOP("KeyMenu", "&Constant"), Interpolation::constant);
  if (may_have_tangents(document.scene(), track)) {
    menu->addSeparator();
    const auto add_tangents = [&](const char* text, Tangents tangents) {
      add(menu_text(text), now.interpolation == Interpolation::smooth && now.tangents == tangents,
          [&document, keys, tangents] { set_tangents(document, keys, tangents); });
    };
    add_tangents(QT_TRANSLATE_NOOP("KeyMenu", "Automatic &Tangents"), Tangents::automatic);
    add_tangents(QT_TRANSLATE_NOOP("KeyMenu", "Ali&gned Tangents"), Tangents::aligned);
    add_tangents(QT_TRANSLATE_NOOP("KeyMenu", "&Free Tangents"), Tangents::free);
  }
  menu->addSeparator();
  for (const KeyAction& action : actions) menu->addAction(action.text, &owner, action.run);
  menu->popup(global_position);
}

double snapped_shift(const Timeline& timeline, double grabbed_time, double moved_frames,
                     double first_time) {
  const double frames = std::round(moved_frames);
  if (frames == 0.0) return 0.0;
  const double frame = std::round(timeline.frame_of(grabbed_time) + frames);
  return std::max(timeline.time_of(frame) - grabbed_time, std::min(0.0, -first_time));
}

double on_frame(const Timeline& timeline, double time) {
  const double nearest = timeline.time_of(std::round(timeline.frame_of(time)));
  return is_same_key_time(nearest, time) ? nearest : time;
}

QPolygonF key_shape(Interpolation interpolation, const QPointF& center, double radius) {
  const double r = radius;
  QPolygonF shape;
  switch (interpolation) {
    case Interpolation::smooth:
      shape << QPointF(0, -r) << QPointF(r, 0) << QPointF(0, r) << QPointF(-r, 0);
      break;
    case Interpolation::linear:
      shape << QPointF(-0.8 * r, -0.8 * r) << QPointF(0.8 * r, -0.8 * r)
            << QPointF(0.8 * r, 0.8 * r) << QPointF(-0.8 * r, 0.8 * r);
      break;
    case Interpolation::constant:
      shape << QPointF(-0.7 * r, -r) << QPointF(r, 0) << QPointF(-0.7 * r, r);
      break;
  }
  return shape.translated(center);
}

}  // namespace brume
