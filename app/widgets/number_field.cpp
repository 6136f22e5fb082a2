#include "app/widgets/number_field.h"

#include <QKeyEvent>

#include "app/document/gaussian_attribute.h"
#include "app/document/text/number_text.h"
#include "app/widgets/field_filter.h"
#include "app/widgets/interface_settings.h"

namespace brume {

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
  setAlignment(Qt::AlignRight);
}

void NumberField::show_value(std::optional<double> value) {
  value_ = value;
  is_mixed_ = false;
  setPlaceholderText(QString(QChar(0x2013)));
  if (!hasFocus() || !isModified()) revert();  // what is being typed stays
}

void NumberField::show_mixed() {
  show_value(std::nullopt);
  is_mixed_ = true;
  setPlaceholderText(tr("mixed"));
}

void NumberField::show_length_unit() {
  is_length_ = true;
  connect(&InterfaceSettings::instance(), &InterfaceSettings::changed, this, [this] {
    if (!hasFocus()) revert();
  });
  revert();
}

QString NumberField::shown_text() const {
  if (!value_) return {};
  // All digits only for who is about to edit them.
  if (hasFocus()) return exact_number_text(*value_);
  const QString& unit = InterfaceSettings::instance().length_unit();
  const QString number = number_text(*value_);
  return is_length_ && !unit.isEmpty() ? number + ' ' + unit : number;
}

QString NumberField::typed_text() const {
  const QString& unit = InterfaceSettings::instance().length_unit();
  QString typed = text().trimmed();
  if (is_length_ && !unit.isEmpty() && typed.endsWith(unit)) typed.chop(unit.size());
  return typed;
}

void NumberField::revert() {
  setText(shown_text());
  setCursorPosition(0);
}

void NumberField::commit() {
  if (!isModified()) return;
  setModified(false);
  const std::optional<Adjustment> adjustment = parse_adjustment(typed_text());
  if (adjustment && is_mixed_) {
    Q_EMIT adjusted(*adjustment);
  } else {
    Q_EMIT committed(adjustment && value_ ? adjustment->of(*value_) : parse_number(typed_text()));
  }
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
