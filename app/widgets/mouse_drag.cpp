#include "app/widgets/mouse_drag.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>

namespace brume {
namespace {

bool is_modifier(int key) {
  return key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt ||
         key == Qt::Key_Meta || key == Qt::Key_AltGr;
}

}  // namespace

void MouseDrag::press(QPointF position, bool is_stroke) {
  press_ = position;
  is_stroke_ = is_stroke;
  is_down_ = is_running_ = true;
  has_begun_ = false;
  QCoreApplication::instance()->installEventFilter(this);
}

void MouseDrag::release() {
  is_down_ = is_running_ = false;
  QCoreApplication::instance()->removeEventFilter(this);
}

bool MouseDrag::has_begun(QPointF position) {
  if (!is_running_) return false;
  has_begun_ = has_begun_ || is_stroke_ || QLineF(press_, position).length() >= max_slip;
  return has_begun_;
}

bool MouseDrag::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  // The right button opens no menu while the left one is down.
  if (type == QEvent::ContextMenu && is_down_) return true;
  if (!is_running_) return false;
  if (type == QEvent::ShortcutOverride || type == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key != Qt::Key_Escape && (is_stroke_ || is_modifier(key))) return false;
    if (key != Qt::Key_Escape) {
      is_running_ = false;
      Q_EMIT ended();
      return false;
    }
    event->accept();  // it is no shortcut now
    if (type == QEvent::KeyPress) {
      is_running_ = false;
      Q_EMIT cancelled();
    }
    return true;
  }
  const bool is_cancel = type == QEvent::MouseButtonPress && watched->isWidgetType() &&
                         static_cast<QMouseEvent*>(event)->button() == Qt::RightButton;
  if (!is_cancel) return false;
  is_running_ = false;
  Q_EMIT cancelled();
  return true;
}

}  // namespace brume
