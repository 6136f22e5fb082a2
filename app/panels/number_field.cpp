#include "app/panels/number_field.h"

#include <QKeyEvent>

#include "app/document/gaussian_field.h"

namespace brume {

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
  setAlignment(Qt::AlignRight);
  setPlaceholderText(QString(QChar(0x2013)));
}

void NumberField::show_value(std::optional<double> value) {
  value_ = value;
  revert();
}

void NumberField::revert() {
  setText(value_ ? exact_number_text(*value_) : QString());
  setCursorPosition(0);  // the leading digits are those that matter
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

void NumberField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  revert();
}

}  // namespace brume
