#include "app/document/gaussian_field.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/document/arithmetic.h"

namespace brume {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("GaussianField", text);
}

}  // namespace

const NumberDomain& field_domain(GaussianField field) {
  switch (field) {
    case GaussianField::radius:
      return domain::length;
    case GaussianField::density:
      return domain::density;
    default:
      return domain::coordinate;
  }
}

QString field_title(GaussianField field) {
  switch (field) {
    case GaussianField::center_x:
      return tr("Center X");
    case GaussianField::center_y:
      return tr("Center Y");
    case GaussianField::center_z:
      return tr("Center Z");
    case GaussianField::radius:
      return tr("Radius");
    case GaussianField::density:
      return tr("Density");
  }
  return {};
}

QString field_name(GaussianField field) {
  return field_title(field).toLower();
}

double field_value(const Gaussian& gaussian, GaussianField field) {
  switch (field) {
    case GaussianField::center_x:
      return gaussian.center.x;
    case GaussianField::center_y:
      return gaussian.center.y;
    case GaussianField::center_z:
      return gaussian.center.z;
    case GaussianField::radius:
      return gaussian.radius;
    case GaussianField::density:
      return gaussian.density;
  }
  return 0.0;
}

void set_field_value(Gaussian& gaussian, GaussianField field, double value) {
  switch (field) {
    case GaussianField::center_x:
      gaussian.center.x = value;
      break;
    case GaussianField::center_y:
      gaussian.center.y = value;
      break;
    case GaussianField::center_z:
      gaussian.center.z = value;
      break;
    case GaussianField::radius:
      gaussian.radius = value;
      break;
    case GaussianField::density:
      gaussian.density = value;
      break;
  }
}

Gaussian within_domains(const Gaussian& gaussian) {
  Gaussian result = gaussian;
  for (const GaussianField field : gaussian_fields) {
    const NumberDomain& domain = field_domain(field);
    const double value = field_value(gaussian, field);
    set_field_value(result, field, std::clamp(value, domain.least, domain.greatest));
  }
  return result;
}

QString field_problem(GaussianField field, double value) {
  const NumberDomain& domain = field_domain(field);
  if (domain.contains(value)) return {};
  const QString rule = tr("%1 must be %2").arg(field_title(field), domain.allowed);
  // What is no number at all was text that only the user knows.
  if (std::isnan(value)) return rule + '.';
  return tr("%1, not %2.").arg(rule, number_text(value));
}

double parse_number(const QString& text) {
  QString plain = text.trimmed();
  plain.replace(QChar(0x2212), QLatin1Char('-'));
  bool ok = false;
  double value = plain.toDouble(&ok);
  // A decimal comma is what many keyboards give.
  if (!ok) value = plain.replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&ok);
  if (ok) return value;
  return evaluate(plain).value_or(std::numeric_limits<double>::quiet_NaN());
}

QString number_text(double value) {
  return QString::number(value, 'g', 6);
}

QString exact_number_text(double value) {
  return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QString gaussians_text(std::size_t count) {
  return count == 1 ? tr("Gaussian") : tr("%1 Gaussians").arg(count);
}

}  // namespace brume
