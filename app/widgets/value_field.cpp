#include "app/widgets/value_field.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "app/document/gaussian_attribute.h"
#include "app/document/text/words.h"
#include "app/widgets/number_field.h"
#include "core/math/rounded.h"

namespace brume {
namespace {

constexpr double steps_per_notch = 5.0;

}  // namespace

ValueField::ValueField(const QString& title, const NumberDomain& domain, Scale scale, double step,
                       QWidget* parent)
    : QWidget(parent),
      title_(title),
      domain_(domain),
      scale_(scale),
      step_(step),
      label_(new QLabel(title, this)),
      field_(new NumberField(this)) {
  label_->setCursor(Qt::SizeHorCursor);
  label_->installEventFilter(this);
  label_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  field_->setMinimumWidth(field_->fontMetrics().horizontalAdvance("0.0000"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  layout->addWidget(label_);
  layout->addWidget(field_, 1);
  connect(field_, &NumberField::committed, this, [this](double value) {
    if (domain_.contains(value)) {
      Q_EMIT edited(value, no_merge);
    } else {
      Q_EMIT refused(tr("%1 must be %2.").arg(title_, allowed_text(domain_)));
    }
  });
  connect(field_, &NumberField::adjusted, this, &ValueField::adjusted);
  connect(&mouse_, &MouseDrag::cancelled, this, [this] {
    if (!pressed_ || value_ == pressed_) return;
    value_ = pressed_;
    Q_EMIT edited(*pressed_, gesture_);
  });
}

QString ValueField::range() const {
  return tr("Allowed: %1").arg(allowed_text(domain_));
}

QLabel* ValueField::detach_title() {
  layout()->removeWidget(label_);
  return label_;
}

void ValueField::show_value(std::optional<double> value) {
  value_ = value;
  field_->show_value(value);
}

void ValueField::show_mixed() {
  value_.reset();
  field_->show_mixed();
}

void ValueField::change(double steps, Qt::KeyboardModifiers modifiers) {
  if (!value_ || steps == 0.0) return;
  if (modifiers.testFlag(Qt::ControlModifier)) steps *= 0.1;
  if (modifiers.testFlag(Qt::ShiftModifier)) steps *= 10.0;
  // From 0, which no factor moves, to something small that one does.
  const double start =
      scale_ == Scale::logarithmic && *value_ == 0.0 && steps > 0.0 ? 1e-3 : *value_;
  double value =
      scale_ == Scale::linear ? start + steps * step_ : start * std::pow(1.0 + step_, steps);
  value = std::clamp(rounded(value, 4), domain_.min_value, domain_.max_value);
  if (!domain_.contains(value) || value == *value_) return;
  value_ = value;
  Q_EMIT edited(value, gesture_);
}

bool ValueField::eventFilter(QObject* watched, QEvent* event) {
  if (!isEnabled()) return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::MouseButtonPress) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton) return true;
    gesture_ = new_merge_id();
    last_x_ = mouse->globalPosition().x();
    pressed_ = value_;
    mouse_.press(mouse->globalPosition());
    return true;
  }
  if (event->type() == QEvent::MouseButtonRelease) mouse_.release();
  if (event->type() == QEvent::MouseMove) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (!mouse_.has_begun(mouse->globalPosition())) return true;
    const double x = mouse->globalPosition().x();
    // Small steps may round to nothing: they wait until they add up.
    const double before = value_.value_or(0.0);
    change(x - last_x_, mouse->modifiers());
    if (value_.value_or(0.0) != before) last_x_ = x;
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void ValueField::wheelEvent(QWheelEvent* event) {
  if (!field_->hasFocus()) {
    event->ignore();  // whoever scrolls past means the panel
    return;
  }
  field_->commit();
  change(steps_per_notch * event->angleDelta().y() / 120.0, event->modifiers());
  event->accept();
}

void ValueField::enterEvent(QEnterEvent* event) {
  gesture_ = new_merge_id();
  QWidget::enterEvent(event);
}

void show_length_units(const QWidget& form, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    for (const char* part : {"", "_x", "_y", "_z"}) {
      if (auto* field = form.findChild<ValueField*>(QString(name) + part)) {
        field->number().show_length_unit();
      }
    }
  }
}

}  // namespace brume
