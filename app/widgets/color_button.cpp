#include "app/widgets/color_button.h"

#include <QColorDialog>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace brume {
namespace {

// IEC 61966-2-1.
double encoded(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

double decoded(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

QColor to_color(const glm::dvec3& linear) {
  return QColor::fromRgbF(static_cast<float>(encoded(linear.r)),
                          static_cast<float>(encoded(linear.g)),
                          static_cast<float>(encoded(linear.b)));
}

glm::dvec3 to_linear(const QColor& color) {
  return {decoded(color.redF()), decoded(color.greenF()), decoded(color.blueF())};
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
}

void ColorButton::show_color(const glm::dvec3& linear) {
  color_ = linear;
  setIcon(color_swatch(linear, iconSize()));
}

void ColorButton::open_dialog() {
  auto* dialog = new QColorDialog(to_color(color_), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setOptions(QColorDialog::NoButtons | QColorDialog::DontUseNativeDialog);
  const MergeId gesture = new_merge_id();
  connect(dialog, &QColorDialog::currentColorChanged, this,
          [this, gesture](const QColor& color) { Q_EMIT edited(to_linear(color), gesture); });
  dialog->show();
}

}  // namespace brume
