#include "app/widgets/color_button.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "app/document/gaussian_attribute.h"
#include "app/widgets/interface_settings.h"
#include "app/widgets/value_field.h"
#include "core/math/srgb.h"
#include "core/number_domain.h"
#include "core/scene/lights/photometry.h"

namespace brume {
namespace {

double encoded(double linear) {
  return srgb_encoded(std::clamp(linear, 0.0, 1.0));
}

// A new row below all else of a dialog, which begins with a title.
QHBoxLayout* add_titled_row(QColorDialog& dialog, const QString& title) {
  auto* row = new QHBoxLayout;
  static_cast<QBoxLayout*>(dialog.layout())->addLayout(row);
  row->addWidget(new QLabel(title, &dialog));
  return row;
}

}  // namespace

QColor to_color(const glm::dvec3& linear) {
  return QColor::fromRgbF(static_cast<float>(encoded(linear.r)),
                          static_cast<float>(encoded(linear.g)),
                          static_cast<float>(encoded(linear.b)));
}

glm::dvec3 to_linear(const QColor& color) {
  return {srgb_decoded(color.redF()), srgb_decoded(color.greenF()), srgb_decoded(color.blueF())};
}

std::optional<TypedColor> parse_color(const QString& text) {
  const QString plain = text.trimmed();
  if (plain.startsWith('#')) {
    const QColor color(plain);
    if (!color.isValid() || color.alpha() < 255) return std::nullopt;
    return TypedColor{to_linear(color), true};
  }
  if (plain.endsWith('K', Qt::CaseInsensitive)) {
    const double temperature = parse_number(plain.chopped(1));
    if (!domain::temperature.contains(temperature)) return std::nullopt;
    return TypedColor{glm::max(black_body_color(temperature), 0.0), true};
  }
  static const QRegularExpression spaces("[\\s;]+");
  QStringList numbers = plain.split(spaces, Qt::SkipEmptyParts);
  if (numbers.size() == 1) numbers = plain.split(',');
  if (numbers.size() != 3) return std::nullopt;
  glm::dvec3 linear(0.0);
  for (int k = 0; k < 3; ++k) {
    if (numbers[k].endsWith(',')) numbers[k].chop(1);
    linear[k] = parse_number(numbers[k]);
    if (std::isnan(linear[k])) return std::nullopt;
  }
  return TypedColor{linear, false};
}

QPixmap color_swatch(const glm::dvec3& linear, const QSize& size) {
  QPixmap swatch(size);
  swatch.fill(to_color(linear));
  QPainter painter(&swatch);
  painter.setPen(QColor(128, 128, 128));
  painter.drawRect(0, 0, size.width() - 1, size.height() - 1);
  return swatch;
}

ColorButton::ColorButton(QWidget* parent) : QToolButton(parent) {
  setIconSize({34, 16});
  show_color(color_);
  connect(this, &QToolButton::clicked, this, &ColorButton::open_dialog);
  connect(&InterfaceSettings::instance(), &InterfaceSettings::changed, this,
          [this] { show_color(color_); });
}

void ColorButton::show_color(const glm::dvec3& linear) {
  color_ = linear;
  setIcon(color_swatch(linear, iconSize()));
  setToolTip(color_numbers_text(linear));
}

void ColorButton::open_dialog() {
  auto* dialog = new QColorDialog(to_color(color_), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Choose a Colour"));
  dialog->setOptions(QColorDialog::NoButtons | QColorDialog::DontUseNativeDialog);
  const MergeId gesture = new_merge_id();
  connect(dialog, &QColorDialog::currentColorChanged, this,
          [this, gesture](const QColor& color) { Q_EMIT edited(to_linear(color), gesture); });
  add_temperatures(*dialog);
  if (InterfaceSettings::instance().color_numbers() == InterfaceSettings::ColorNumbers::linear) {
    add_linear_fields(*dialog, gesture);
  }
  dialog->show();
}

void ColorButton::add_temperatures(QColorDialog& dialog) {
  struct Source {
    int temperature;  // [K]
    const char* name;
  };
  constexpr auto sources = std::to_array<Source>({{1000, QT_TR_NOOP("embers")},
                                                  {1850, QT_TR_NOOP("a candle")},
                                                  {2700, QT_TR_NOOP("a bulb")},
                                                  {3200, QT_TR_NOOP("a halogen light")},
                                                  {4300, QT_TR_NOOP("moonlight")},
                                                  {5600, QT_TR_NOOP("daylight")},
                                                  {6500, QT_TR_NOOP("an overcast sky")},
                                                  {10'000, QT_TR_NOOP("a blue sky")}});
  QHBoxLayout* row = add_titled_row(dialog, tr("Temperature"));
  for (const auto& [temperature, name] : sources) {
    auto* swatch = new QToolButton(&dialog);
    swatch->setObjectName(QString("color_%1_K").arg(temperature));
    swatch->setToolTip(tr("%1 K: %2").arg(temperature).arg(tr(name)));
    const QColor color = to_color(black_body_color(temperature));
    swatch->setIcon(color_swatch(to_linear(color), iconSize()));
    swatch->setIconSize(iconSize());
    row->addWidget(swatch);
    connect(swatch, &QToolButton::clicked, &dialog,
            [&dialog, color] { dialog.setCurrentColor(color); });
  }
  row->addStretch();
}

void ColorButton::add_linear_fields(QColorDialog& dialog, MergeId gesture) {
  QHBoxLayout* row = add_titled_row(dialog, tr("Linear"));
  for (int k = 0; k < 3; ++k) {
    auto* field = new ValueField(QString("RGB").at(k), domain::unit, ValueField::Scale::linear,
                                 0.002, &dialog);
    field->setObjectName(QString("linear_%1").arg(QString("rgb").at(k)));
    field->show_value(color_[k]);
    row->addWidget(field);
    connect(&dialog, &QColorDialog::currentColorChanged, field,
            [field, k](const QColor& color) { field->show_value(to_linear(color)[k]); });
    // The number itself, which a colour of the dialog may round.
    connect(field, &ValueField::edited, this, [this, &dialog, gesture, field, k](double value) {
      glm::dvec3 linear = color_;
      linear[k] = value;
      const QSignalBlocker blocker(dialog);
      dialog.setCurrentColor(to_color(linear));
      field->show_value(value);
      Q_EMIT edited(linear, gesture);
    });
  }
}

}  // namespace brume
