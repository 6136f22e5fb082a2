#include "app/widgets/field_filter.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QScrollBar>
#include <QSpinBox>
#include <QTableView>
#include <QToolTip>

#include "app/widgets/accessible_names.h"
#include "app/widgets/form_rows.h"
#include "app/widgets/keys.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/value_field.h"

namespace brume {
namespace {

// Whether the wheel would change the widget's value.
bool has_wheel_value(const QWidget* widget) {
  if (qobject_cast<const QScrollBar*>(widget)) return false;
  return qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QAbstractSlider*>(widget);
}

// The line that is typed into, cells of tables and names in lists among them; nullptr: none.
QLineEdit* line_of(QWidget* field) {
  if (qobject_cast<QAbstractSpinBox*>(field)) return field->findChild<QLineEdit*>();
  return qobject_cast<QLineEdit*>(field);
}

// Ends typing in the field that has the focus, unless it is `except`.
void leave_focused_field(const QWidget* except) {
  QWidget* field = QApplication::focusWidget();
  if (!line_of(field) || field == except || field->isAncestorOf(except)) return;
  leave_field(*field);
}

// QLineEdit takes the keys of undo and redo even where it has nothing to undo.
bool is_of_document(const QKeyEvent& key, const QLineEdit& line) {
  if (line.isModified()) return false;
  return key.matches(QKeySequence::Undo) ||
         (key.matches(QKeySequence::Redo) && !line.isRedoAvailable());
}

// Keys that search, delete or go to an end of a list.
bool acts_in_list(const QKeyEvent& key) {
  const bool is_plain = !(key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
  return is_typed(key) || (is_plain && (key.key() == Qt::Key_Delete || key.key() == Qt::Key_Home ||
                                        key.key() == Qt::Key_End));
}

// Enter commits text typed into a spin box, Escape reverts it.
bool end_typing(QSpinBox& box, int key) {
  if (key == Qt::Key_Escape) {
    box.setValue(box.value());
  } else if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    box.interpretText();
  } else {
    return false;
  }
  return leave_field(box);
}

// A label or value of a form has its own tool tip, or else that of another widget in the row, and
// the range of a number.
QString value_tool_tip(QWidget* widget) {
  const QWidgetList row = row_with(widget);
  QString text;
  const ValueField* number = qobject_cast<ValueField*>(widget);
  for (QWidget* other : QWidgetList{widget} + row) {
    if (text.isEmpty()) text = other ? other->toolTip() : QString();
    if (!number && widget == row.value(0)) number = qobject_cast<ValueField*>(other);
  }
  if (row.isEmpty() || text.isEmpty()) return {};
  if (!Qt::mightBeRichText(text)) text = plain_tool_tip(text);
  return number ? text + "<br>" + number->range().toHtmlEscaped() : text;
}

}  // namespace

void commit_typing() {
  leave_focused_field(nullptr);
}

bool leave_field(QWidget& field) {
  for (QWidget* above = &field; above; above = above->parentWidget()) {
    if (qobject_cast<QDialog*>(above)) return false;
    const auto* main = qobject_cast<QMainWindow*>(above);
    if (!main && above->isWindow() && above->windowType() == Qt::Window) {
      field.clearFocus();
      return true;
    }
    if (!main) continue;
    QWidget* middle = main->centralWidget();
    if (!middle) return false;
    if (field.window() != main) {
      // A panel that floats keeps its focus until the desktop has activated the other window.
      field.clearFocus();
      middle->activateWindow();
    }
    middle->setFocus();
    return true;
  }
  return false;
}

bool FieldFilter::eventFilter(QObject* watched, QEvent* event) {
  auto* widget = qobject_cast<QWidget*>(watched);
  switch (event->type()) {
    case QEvent::Polish:
      // Or else the wheel would give it the focus first.
      if (has_wheel_value(widget) && widget->focusPolicy() == Qt::WheelFocus) {
        widget->setFocusPolicy(Qt::StrongFocus);
      }
      [[fallthrough]];
    case QEvent::Show:
    case QEvent::ToolTipChange:
      if (widget) update_accessible_name(*widget);
      break;
    case QEvent::Enter:
      // Where one comes back to the picture with the mouse, letters are commands again; the cells
      // of a table are still typed into.
      if (QWidget* focused = QApplication::focusWidget();
          focused && !line_of(focused) && !qobject_cast<QTableView*>(focused) &&
          !focused->property("keeps_focus").toBool()) {
        const auto* main = qobject_cast<QMainWindow*>(focused->window());
        if (main && widget == main->centralWidget() && !widget->isAncestorOf(focused)) {
          leave_field(*focused);
        }
      }
      break;
    case QEvent::Wheel:
      if (has_wheel_value(widget) && !widget->hasFocus()) {
        event->ignore();
        return true;  // on to what it is in
      }
      break;
    case QEvent::MouseButtonPress:
      // Widgets that accept focus by click have it by now.
      if (widget && !QApplication::activePopupWidget()) leave_focused_field(widget);
      break;
    case QEvent::FocusIn:
      // Earlier typing has been taken.
      if (line_of(widget) && static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason) {
        line_of(widget)->setModified(false);
      }
      break;
    case QEvent::ShortcutOverride:
      // Keys in a list are no commands: X would delete what is selected.
      if (qobject_cast<QAbstractItemView*>(widget) &&
          acts_in_list(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
      }
      if (const QLineEdit* line = line_of(widget);
          line && is_of_document(*static_cast<QKeyEvent*>(event), *line)) {
        event->ignore();
        return true;
      }
      break;
    case QEvent::ToolTip:
      if (const QString text = value_tool_tip(widget); !text.isEmpty()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text, widget);
        return true;
      }
      break;
    case QEvent::KeyPress:
      if (auto* box = qobject_cast<QSpinBox*>(widget)) {
        return end_typing(*box, static_cast<QKeyEvent*>(event)->key());
      }
      break;
    case QEvent::Shortcut:
      commit_typing();
      break;
    case QEvent::Close:
      if (qobject_cast<QMainWindow*>(widget)) commit_typing();
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace brume
