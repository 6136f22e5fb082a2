#include "app/document/gaussian_attribute.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "app/document/euler_angles.h"
#include "app/document/text/arithmetic.h"
#include "app/document/text/number_text.h"
#include "app/document/text/words.h"
#include "core/math/max_component.h"
#include "core/math/rounded.h"
#include "core/scene/lights/photometry.h"

namespace brume {
namespace {

QString attribute_text(const char* text, int count = -1) {
  return QCoreApplication::translate("GaussianField", text, nullptr, count);
}

struct AttributeInfo {
  const char* id;
  const char* title;
  const NumberDomain& domain;
};

const AttributeInfo& info(GaussianAttribute field) {
  // In the order of the enumeration.
  static constexpr auto all = std::to_array<AttributeInfo>({
      {"center_x", QT_TRANSLATE_NOOP("GaussianField", "Centre X"), domain::coordinate},
      {"center_y", QT_TRANSLATE_NOOP("GaussianField", "Centre Y"), domain::coordinate},
      {"center_z", QT_TRANSLATE_NOOP("GaussianField", "Centre Z"), domain::coordinate},
      {"radius", QT_TRANSLATE_NOOP("GaussianField", "Radius"), domain::length},
      {"density", QT_TRANSLATE_NOOP("GaussianField", "Density"), domain::density},
      {"albedo", QT_TRANSLATE_NOOP("GaussianField", "Albedo"), domain::albedo},
      {"emission", QT_TRANSLATE_NOOP("GaussianField", "Emission"), domain::intensity},
      {"radius_x", QT_TRANSLATE_NOOP("GaussianField", "Radius X"), domain::length},
      {"radius_y", QT_TRANSLATE_NOOP("GaussianField", "Radius Y"), domain::length},
      {"radius_z", QT_TRANSLATE_NOOP("GaussianField", "Radius Z"), domain::length},
      {"rotation_x", QT_TRANSLATE_NOOP("GaussianField", "Rotation X"), domain::degrees},
      {"rotation_y", QT_TRANSLATE_NOOP("GaussianField", "Rotation Y"), domain::degrees},
      {"rotation_z", QT_TRANSLATE_NOOP("GaussianField", "Rotation Z"), domain::degrees},
      {"elongation", QT_TRANSLATE_NOOP("GaussianField", "Elongation"), domain::elongation},
  });
  static_assert(all.size() == gaussian_attributes.size());
  return all[static_cast<std::size_t>(field)];
}

// Grey stays what it is, to the last bit.
double albedo_luminance(const glm::dvec3& albedo) {
  return albedo == glm::dvec3(albedo.x) ? albedo.x : luminance(albedo);
}

int axis_of(GaussianAttribute field, GaussianAttribute first) {
  return static_cast<int>(field) - static_cast<int>(first);
}

// The radius as it was set, whatever the greatest radius has become since.
double radius_along(const Gaussian& gaussian, int axis) {
  const double stretch = gaussian.shape.stretch[axis];
  return stretch == 1.0 ? gaussian.radius : rounded(gaussian.radius * stretch, 15);
}

}  // namespace

bool is_of_shape(GaussianAttribute field) {
  return field >= GaussianAttribute::radius_x;
}

const NumberDomain& attribute_domain(GaussianAttribute field) {
  return info(field).domain;
}

const char* attribute_id(GaussianAttribute field) {
  return info(field).id;
}

QString attribute_title(GaussianAttribute field) {
  return attribute_text(info(field).title);
}

QString attribute_name(GaussianAttribute field) {
  return in_sentence(attribute_title(field));
}

double attribute_value(const Gaussian& gaussian, GaussianAttribute field) {
  switch (field) {
    case GaussianAttribute::center_x:
    case GaussianAttribute::center_y:
    case GaussianAttribute::center_z:
      return gaussian.center[axis_of(field, GaussianAttribute::center_x)];
    case GaussianAttribute::radius:
      return gaussian.radius;
    case GaussianAttribute::density:
      return gaussian.density;
    case GaussianAttribute::albedo:
      return albedo_luminance(gaussian.optics.albedo.value_or(glm::dvec3(1.0)));
    case GaussianAttribute::emission:
      return emission_strength(gaussian.optics.emission);
    case GaussianAttribute::radius_x:
    case GaussianAttribute::radius_y:
    case GaussianAttribute::radius_z:
      return radius_along(gaussian, axis_of(field, GaussianAttribute::radius_x));
    case GaussianAttribute::rotation_x:
    case GaussianAttribute::rotation_y:
    case GaussianAttribute::rotation_z: {
      const int axis = axis_of(field, GaussianAttribute::rotation_x);
      return gaussian.is_ball() ? 0.0 : to_euler_angles(gaussian.shape.rotation)[axis];
    }
    case GaussianAttribute::elongation:
      return 1.0 / min_component(gaussian.shape.stretch);
  }
  return 0.0;
}

void set_attribute_value(Gaussian& gaussian, GaussianAttribute field, double value) {
  switch (field) {
    case GaussianAttribute::center_x:
    case GaussianAttribute::center_y:
    case GaussianAttribute::center_z:
      gaussian.center[axis_of(field, GaussianAttribute::center_x)] = value;
      break;
    case GaussianAttribute::radius:
      gaussian.radius = value;
      break;
    case GaussianAttribute::density:
      gaussian.density = value;
      break;
    case GaussianAttribute::albedo:
      gaussian.optics.albedo = glm::dvec3(value);
      break;
    case GaussianAttribute::emission:
      if (value == emission_strength(gaussian.optics.emission)) break;  // not even rounded
      gaussian.optics.emission = value * emission_color(gaussian.optics.emission);
      break;
    case GaussianAttribute::radius_x:
    case GaussianAttribute::radius_y:
    case GaussianAttribute::radius_z: {
      glm::dvec3 radii = gaussian.radii();
      radii[axis_of(field, GaussianAttribute::radius_x)] = value;
      gaussian.set_radii(radii, gaussian.shape.rotation);
      break;
    }
    case GaussianAttribute::rotation_x:
    case GaussianAttribute::rotation_y:
    case GaussianAttribute::rotation_z: {
      if (gaussian.is_ball()) break;
      glm::dvec3 angles = to_euler_angles(gaussian.shape.rotation);
      angles[axis_of(field, GaussianAttribute::rotation_x)] = value;
      gaussian.shape.rotation = from_euler_angles(angles);
      break;
    }
    case GaussianAttribute::elongation:
      break;
  }
}

double extinction_over_density(const glm::dvec3& albedo) {
  constexpr double min_albedo = 0.01;
  return albedo_luminance(1.0 / glm::max(albedo, min_albedo));
}

Gaussian within_domains(const Gaussian& gaussian) {
  Gaussian result = gaussian;
  for (const GaussianAttribute field : gaussian_attributes) {
    if (field == GaussianAttribute::albedo) continue;  // by channel
    if (is_of_shape(field)) break;
    const NumberDomain& domain = attribute_domain(field);
    const double value = attribute_value(gaussian, field);
    set_attribute_value(result, field, std::clamp(value, domain.min_value, domain.max_value));
  }
  if (auto& albedo = result.optics.albedo) {
    albedo = glm::clamp(*albedo, domain::albedo.min_value, domain::albedo.max_value);
  }
  if (!result.is_ball() && min_component(result.radii()) < domain::length.min_value) {
    result.set_radii(glm::max(result.radii(), domain::length.min_value), result.shape.rotation);
  }
  return result;
}

double emission_strength(const glm::dvec3& emission) {
  return max_component(emission);
}

glm::dvec3 emission_color(const glm::dvec3& emission) {
  const double strength = emission_strength(emission);
  return strength > 0.0 ? emission / strength : glm::dvec3(1.0);
}

QString attribute_problem(GaussianAttribute field, double value) {
  const NumberDomain& domain = attribute_domain(field);
  if (domain.contains(value)) return {};
  const QString rule =
      attribute_text("%1 must be %2").arg(attribute_title(field), allowed_text(domain));
  // NaN was text that only the user knows.
  if (std::isnan(value)) return rule + '.';
  return attribute_text("%1, not %2.").arg(rule, number_text(value));
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

QString gaussians_text(std::size_t count) {
  return attribute_text("%n Gaussian(s)", static_cast<int>(count));
}

}  // namespace brume
