#include "app/view/camera/fly_keys.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <algorithm>
#include <array>

#include "app/widgets/keys.h"

namespace brume {
namespace {

constexpr int step_time = 15;        // milliseconds
constexpr double max_seconds = 0.1;  // of one step, however long a frame takes
constexpr double haste = 4.0;        // with Shift, and its inverse with Ctrl

struct Way {
  int key;
  glm::dvec3 direction;
};
constexpr std::array ways{Way{Qt::Key_D, {1, 0, 0}}, Way{Qt::Key_A, {-1, 0, 0}},
                          Way{Qt::Key_E, {0, 1, 0}}, Way{Qt::Key_Q, {0, -1, 0}},
                          Way{Qt::Key_W, {0, 0, 1}}, Way{Qt::Key_S, {0, 0, -1}}};

bool flies(int key) {
  return std::ranges::any_of(ways, [key](const Way& way) { return way.key == key; });
}

// A dialog, or another program, takes the mouse and the keys.
bool takes_input_away(const QEvent& event) {
  if (event.type() == QEvent::WindowBlocked) return true;
  return event.type() == QEvent::ApplicationStateChange &&
         static_cast<const QApplicationStateChangeEvent&>(event).applicationState() !=
             Qt::ApplicationActive;
}

}  // namespace

FlyKeys::FlyKeys(QObject* parent) : QObject(parent) {
  timer_.setInterval(step_time);
  connect(&timer_, &QTimer::timeout, this, &FlyKeys::move);
}

void FlyKeys::press() {
  is_running_ = true;
  is_used_ = false;
  held_.clear();
  QCoreApplication::instance()->installEventFilter(this);
}

void FlyKeys::release() {
  is_running_ = false;
  timer_.stop();
  QCoreApplication::instance()->removeEventFilter(this);
}

bool FlyKeys::eventFilter(QObject* /*watched*/, QEvent* event) {
  if (takes_input_away(*event)) {
    release();
    Q_EMIT interrupted();
    return false;
  }
  const QEvent::Type type = event->type();
  const bool is_press = type == QEvent::KeyPress || type == QEvent::ShortcutOverride;
  if (!is_press && type != QEvent::KeyRelease) return false;
  const auto& pressed = static_cast<const QKeyEvent&>(*event);
  const auto latin = latin_key(pressed);
  const int key = latin ? latin->key() : pressed.key();
  if (!flies(key)) return false;
  event->accept();
  if (pressed.isAutoRepeat()) return true;
  if (!is_press) {
    move();  // until now
    held_.remove(key);
    if (held_.isEmpty()) timer_.stop();
    return true;
  }
  held_.insert(key);
  is_used_ = true;
  if (!timer_.isActive()) {
    clock_.start();
    timer_.start();
  }
  return true;
}

void FlyKeys::move() {
  glm::dvec3 way(0.0);
  for (const Way& known : ways) {
    if (held_.contains(known.key)) way += known.direction;
  }
  double seconds = std::min(1e-3 * static_cast<double>(clock_.restart()), max_seconds);
  const Qt::KeyboardModifiers modifiers = QGuiApplication::queryKeyboardModifiers();
  if (modifiers.testFlag(Qt::ShiftModifier)) seconds *= haste;
  if (modifiers.testFlag(Qt::ControlModifier)) seconds /= haste;
  if (way != glm::dvec3(0.0)) Q_EMIT moved(seconds * way);
}

}  // namespace brume
