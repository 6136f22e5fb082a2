#include "app/widgets/whole_number_box.h"

#include <QLineEdit>
#include <utility>

namespace brume {

WholeNumberBox::WholeNumberBox(QString title, int low, int high, QWidget* parent)
    : QSpinBox(parent), title_(std::move(title)) {
  setRange(low, high);
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { is_refused_ = false; });
  connect(lineEdit(), &QLineEdit::textChanged, this, &WholeNumberBox::changed);
  connect(this, &QSpinBox::valueChanged, this, &WholeNumberBox::changed);
}

QString WholeNumberBox::message() const {
  return tr("%1 must be a whole number from %2 to %3.").arg(title_).arg(minimum()).arg(maximum());
}

QString WholeNumberBox::problem() const {
  return is_refused_ || !hasAcceptableInput() ? message() : QString();
}

QValidator::State WholeNumberBox::validate(QString& text, int& position) const {
  if (minimum() >= 0 && text.trimmed().startsWith('-')) return QValidator::Intermediate;
  return QSpinBox::validate(text, position);
}

void WholeNumberBox::fixup(QString& text) const {
  is_refused_ = minimum() >= 0 && text.trimmed().startsWith('-');
  if (is_refused_) Q_EMIT refused(message());
  QSpinBox::fixup(text);
}

void WholeNumberBox::stepBy(int steps) {
  is_refused_ = false;
  QSpinBox::stepBy(steps);
  Q_EMIT changed();
}

}  // namespace brume
