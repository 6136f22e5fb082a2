#include "app/panels/forms/key_button.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/commands/objects/edit_keys.h"
#include "app/document/document.h"
#include "app/widgets/icons.h"
#include "app/widgets/keys.h"

namespace brume {
namespace {

// Over a field nothing can be locked.
bool sets_key(const QKeyEvent& event) {
  return is_key_of("time.set_key", event) || is_key_of("select.lock", event);
}

}  // namespace

KeyButton::KeyButton(Document& document, std::function<Track(const Scene&)> track, QWidget* parent)
    : QToolButton(parent), document_(document), track_(std::move(track)) {
  setAutoRaise(true);
  setCheckable(true);
  connect(this, &QToolButton::clicked, this, &KeyButton::toggle);
}

void KeyButton::toggle() {
  const Track value = track_(document_.scene());
  if (has_key_now()) {
    delete_keys(document_, std::array{TrackKeys{value, {document_.time()}}});
  } else {
    set_keys(document_, value);
  }
  refresh();
}

QSize KeyButton::sizeHint() const {
  const int side = fontMetrics().height() + 2;  // of a field, which it is not to heighten
  return {side, side};
}

void KeyButton::refresh() {
  const bool has_key = has_key_now();
  const QIcon icon = load_icon("key");
  setIcon(has_key || keys().empty() ? icon
                                    : QIcon(icon.pixmap(iconSize(), QIcon::Normal, QIcon::On)));
  setChecked(has_key);
  const QString tip = has_key ? tr("Delete the keyframe at this time (I or K over the field)")
                              : tr("Set a keyframe at this time (I or K over the field)");
  if (tip != toolTip()) setToolTip(tip);  // each new one renames the button
}

std::vector<Keyframe> KeyButton::keys() const {
  return keyframes_of(document_.scene(), track_(document_.scene()));
}

bool KeyButton::has_key_now() const {
  return std::ranges::any_of(
      keys(), [this](const Keyframe& key) { return is_same_key_time(key.time, document_.time()); });
}

void KeyButton::watch(QWidget& field) {
  field.installEventFilter(this);
  watched_.emplace_back(&field);
  for (QLineEdit* text : field.findChildren<QLineEdit*>()) {
    text->installEventFilter(this);
    watched_.emplace_back(text);
  }
}

// Keys go to what has the focus, wherever the mouse is: while that is over a field, this filters
// the events of all widgets.
bool KeyButton::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (type == QEvent::Enter) qApp->installEventFilter(this);
  if (type == QEvent::Leave) qApp->removeEventFilter(this);
  const bool is_key = type == QEvent::ShortcutOverride || type == QEvent::KeyPress;
  if (is_key && isEnabled() && !qobject_cast<QLineEdit*>(QApplication::focusWidget()) &&
      std::ranges::any_of(watched_,
                          [](const auto& field) { return field && field->underMouse(); }) &&
      sets_key(static_cast<const QKeyEvent&>(*event))) {
    event->accept();
    // A key that is held is one press.
    const bool is_repeat = static_cast<const QKeyEvent&>(*event).isAutoRepeat();
    if (type == QEvent::KeyPress && !is_repeat) toggle();
    return true;
  }
  const bool is_own = std::ranges::any_of(
      watched_, [watched](const auto& field) { return field.data() == watched; });
  if (type != QEvent::ContextMenu || !isEnabled() || !is_own) {
    return QToolButton::eventFilter(watched, event);
  }
  auto* text = qobject_cast<QLineEdit*>(watched);
  auto* menu = text ? text->createStandardContextMenu() : new QMenu(this);
  show_menu(*menu, static_cast<QContextMenuEvent*>(event)->globalPos());
  return true;
}

void KeyButton::contextMenuEvent(QContextMenuEvent* event) {
  show_menu(*new QMenu(this), event->globalPos());
}

void KeyButton::show_menu(QMenu& menu, const QPoint& global_position) {
  menu.setAttribute(Qt::WA_DeleteOnClose);
  const std::vector<Keyframe> all = keys();
  const double now = document_.time();
  const auto next = std::ranges::find_if(
      all, [now](const Keyframe& key) { return key.time > now + min_key_distance; });
  const auto previous = std::find_if(all.rbegin(), all.rend(), [now](const Keyframe& key) {
    return key.time < now - min_key_distance;
  });
  QAction* before = menu.actions().value(0);
  const auto add = [&](const QString& text, bool is_possible, auto react) {
    auto* action = new QAction(text, &menu);
    action->setEnabled(is_possible);
    connect(action, &QAction::triggered, this, react);
    menu.insertAction(before, action);
  };
  add(has_key_now() ? tr("Delete Keyframe") : tr("Insert Keyframe"), true, [this] { toggle(); });
  add(tr("Previous Keyframe"), previous != all.rend(),
      [this, time = previous == all.rend() ? 0.0 : previous->time] {
        Q_EMIT time_asked_for(time);
      });
  add(tr("Next Keyframe"), next != all.end(),
      [this, time = next == all.end() ? 0.0 : next->time] { Q_EMIT time_asked_for(time); });
  add(tr("Show Curve"), !all.empty(),
      [this] { Q_EMIT curve_asked_for(track_(document_.scene())); });
  if (before) menu.insertSeparator(before);
  menu.popup(global_position);
}

}  // namespace brume
