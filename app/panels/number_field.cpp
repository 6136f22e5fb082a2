#include "app/panels/number_field.h"

#include <QKeyEvent>

#include "app/document/gaussian_field.h"

namespace brume {

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
  setAlignment(Qt::AlignRight);
}

void NumberField::show_value(std::optional<double> value) {
  value_ = value;
  setPlaceholderText(QString(QChar(0x2013)));
  revert();
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

void NumberField::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter) {
    if (isModified()) Q_EMIT committed(parse_number(text()));
    selectAll();
  } else if (event->key() == Qt::Key_Escape) {
    revert();
  } else {
    QLineEdit::keyPressEvent(event);
  }
}

void NumberField::focusInEvent(QFocusEvent* event) {
  revert();
  QLineEdit::focusInEvent(event);
  selectAll();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  revert();
}

}  // namespace brume
