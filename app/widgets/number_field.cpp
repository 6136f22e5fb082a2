#include "app/widgets/number_field.h"

#include <QKeyEvent>

#include "app/document/gaussian_attribute.h"
#include "app/widgets/field_filter.h"

namespace brume {

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
  setAlignment(Qt::AlignRight);
}

void NumberField::show_value(std::optional<double> value) {
  value_ = value;
  setPlaceholderText(QString(QChar(0x2013)));
  if (!hasFocus() || !isModified()) revert();  // what is being typed stays
}

void NumberField::show_mixed() {
  show_value(std::nullopt);
  setPlaceholderText(tr("mixed"));
}

void NumberField::revert() {
  // All digits only for who is about to edit them.
  setText(!value_ ? QString() : hasFocus() ? exact_number_text(*value_) : number_text(*value_));
  setCursorPosition(0);
}

void NumberField::commit() {
  if (!isModified()) return;
  setModified(false);
  Q_EMIT committed(parse_number(text()));
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter) {
    commit();
    leave_field(*this);
  } else if (event->key() == Qt::Key_Escape) {
    revert();
    leave_field(*this);
  } else {
    QLineEdit::keyPressEvent(event);
  }
}

void NumberField::focusInEvent(QFocusEvent* event) {
  if (!isModified()) revert();
  QLineEdit::focusInEvent(event);
  if (event->reason() != Qt::PopupFocusReason) selectAll();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  if (event->reason() == Qt::PopupFocusReason) return;  // its own menu
  commit();
  revert();
}

}  // namespace brume
