#include "app/panels/gaussians/gaussian_filter.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "core/scene/group_effects.h"

namespace brume {
namespace {

QString filter_text(const char* text) {
  return QCoreApplication::translate("GaussianFilter", text);
}

constexpr std::array attribute_fields{"x", "y", "z", "radius", "density", "albedo", "emission"};
constexpr const char* id_field = "id";

std::optional<GaussianAttribute> attribute_called(const QString& name) {
  for (std::size_t k = 0; k < attribute_fields.size(); ++k) {
    if (QString(attribute_fields[k]).startsWith(name)) return gaussian_attributes[k];
  }
  if (QString(attribute_id(GaussianAttribute::elongation)).startsWith(name)) {
    return GaussianAttribute::elongation;
  }
  // "radius x" and "centre x"
  const QString id = QString(name).replace(' ', '_').replace("centre", "center");
  const auto found = std::ranges::find(gaussian_attributes, id, attribute_id);
  return found == gaussian_attributes.end() ? std::nullopt : std::optional(*found);
}

constexpr const char* group_field = "group";
constexpr const char* no_group = "none";

QString lower_name(const Group* group) {
  return group ? QString::fromStdString(group->name).toLower() : QString(no_group);
}

bool is_in(const QString& name, GroupId id, const std::vector<Group>& groups) {
  const Group* group = find_group(groups, id);
  return lower_name(group) == name ||
         (group && group->parent != 0 && lower_name(find_group(groups, group->parent)) == name);
}

}  // namespace

QString GaussianFilter::field_names() {
  return filter_text(
      "x, y, z, radius, density, albedo, emission, radius x to z, rotation x to z, "
      "elongation, id");
}

std::optional<GaussianFilter> GaussianFilter::parse(const QString& text, QString& problem) {
  // A comma between digits is not a decimal one here: that is what separates conditions.
  static const QRegularExpression separator(R"(\s*(?:,|;|\band\b)\s*)");
  static const QRegularExpression condition(R"(^([^<>=]*?)\s*(<=|>=|<|>|=)\s*(.*)$)");
  GaussianFilter filter;
  for (const QString& part : text.trimmed().toLower().split(separator, Qt::SkipEmptyParts)) {
    const QRegularExpressionMatch match = condition.match(part);
    const QString name = match.captured(1).simplified();
    const QString sign = match.captured(2);
    const QString number = match.captured(3);
    const bool is_of_group = !name.isEmpty() && QString(group_field).startsWith(name);
    const bool is_of_id = !name.isEmpty() && QString(id_field).startsWith(name);
    const auto field = name.isEmpty() ? std::nullopt : attribute_called(name);
    const double value = parse_number(number);
    if (!match.hasMatch()) {
      problem =
          filter_text("“%1” lacks a comparison: <, <=, >, >= or =, as in density > 0.2.").arg(part);
    } else if (!field && !is_of_id && !is_of_group) {
      problem =
          filter_text("“%1” is no attribute; allowed are %2 and group.").arg(name, field_names());
    } else if (is_of_group && sign != "=") {
      problem = filter_text("A group is compared by =, as in group = steam.");
    } else if (number.isEmpty() || (!is_of_group && std::isnan(value))) {
      problem = number.isEmpty() ? filter_text("“%1” lacks what it is compared with.").arg(part)
                                 : filter_text("“%1” is no number.").arg(number);
    } else if (is_of_group) {
      filter.groups_.push_back(number);
      continue;
    } else {
      const Comparison comparison = sign == "<"    ? Comparison::less
                                    : sign == "<=" ? Comparison::at_most
                                    : sign == ">"  ? Comparison::more
                                    : sign == ">=" ? Comparison::at_least
                                                   : Comparison::equal;
      filter.conditions_.push_back({field, comparison, value});
      continue;
    }
    return std::nullopt;
  }
  return filter;
}

bool GaussianFilter::passes(const Gaussian& gaussian, const std::vector<Group>& groups,
                            GaussianId id) const {
  for (const QString& name : groups_) {
    if (!is_in(name, gaussian.group, groups)) return false;
  }
  return std::ranges::all_of(conditions_, [&](const Condition& condition) {
    const double value =
        condition.field ? attribute_value(gaussian, *condition.field) : static_cast<double>(id);
    switch (condition.comparison) {
      case Comparison::less:
        return value < condition.value;
      case Comparison::at_most:
        return value <= condition.value;
      case Comparison::more:
        return value > condition.value;
      case Comparison::at_least:
        return value >= condition.value;
      case Comparison::equal:
        break;
    }
    return value == condition.value;
  });
}

}  // namespace brume
