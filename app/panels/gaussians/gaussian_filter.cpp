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

std::optional<GaussianAttribute> field_called(const QString& name) {
  constexpr std::array names{"x", "y", "z", "radius", "density", "albedo", "emission"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (QString(names[k]).startsWith(name)) return gaussian_attributes[k];
  }
  if (attribute_name(GaussianAttribute::elongation).startsWith(name)) {
    return GaussianAttribute::elongation;
  }
  const auto found = std::ranges::find(gaussian_attributes, name, attribute_name);  // "radius x"
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

std::optional<GaussianFilter> GaussianFilter::parse(const QString& text, QString& problem) {
  // A comma between digits is not a decimal one here: that is what separates conditions.
  static const QRegularExpression separator(R"(\s*(?:,|;|\band\b)\s*)");
  static const QRegularExpression condition(R"(^([a-z]+(?:\s+[xyz])?)\s*(<=|>=|<|>|=)\s*(\S.*)$)");
  GaussianFilter filter;
  for (const QString& part : text.trimmed().toLower().split(separator, Qt::SkipEmptyParts)) {
    const QRegularExpressionMatch match = condition.match(part);
    if (match.hasMatch() && match.captured(2) == "=" &&
        QString(group_field).startsWith(match.captured(1))) {
      filter.groups_.push_back(match.captured(3));
      continue;
    }
    const auto field =
        match.hasMatch() ? field_called(match.captured(1).simplified()) : std::nullopt;
    const double value = match.hasMatch() ? parse_number(match.captured(3)) : 0.0;
    if (!field || std::isnan(value)) {
      problem = filter_text(
                    "“%1” is not a condition. Examples: density > 0.2, radius < 1, x >= 0, group = "
                    "steam.")
                    .arg(part);
      return std::nullopt;
    }
    const QString sign = match.captured(2);
    const Comparison comparison = sign == "<"    ? Comparison::less
                                  : sign == "<=" ? Comparison::at_most
                                  : sign == ">"  ? Comparison::more
                                  : sign == ">=" ? Comparison::at_least
                                                 : Comparison::equal;
    filter.conditions_.push_back({*field, comparison, value});
  }
  return filter;
}

bool GaussianFilter::passes(const Gaussian& gaussian, const std::vector<Group>& groups) const {
  for (const QString& name : groups_) {
    if (!is_in(name, gaussian.group, groups)) return false;
  }
  return std::ranges::all_of(conditions_, [&](const Condition& condition) {
    const double value = attribute_value(gaussian, condition.field);
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
