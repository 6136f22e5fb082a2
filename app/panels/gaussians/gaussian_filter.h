#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/document/gaussian_attribute.h"
#include "brume/group.h"

namespace brume {

// A conjunction of conditions on a Gaussian's attributes and group: "radius < 0.5, group = steam".
class GaussianFilter {
 public:
  // Conditions are separated by commas or "and"; fields are x, y, z, radius, density, albedo,
  // emission, elongation, id and group, or as many of their letters as tell them apart, and in full
  // radius x, y, z and rotation x, y, z; comparisons are
  // < <= > >= =, of a group only = its name, or that of the group it is in, or "none". Empty text
  // lets all pass. nullopt where the text is something else; `problem` then says what.
  static std::optional<GaussianFilter> parse(const QString& text, QString& problem);

  // The fields but the group, in words.
  static QString field_names();

  [[nodiscard]] bool passes(const Gaussian& gaussian, const std::vector<Group>& groups = {},
                            GaussianId id = 0) const;
  [[nodiscard]] bool is_empty() const { return conditions_.empty() && groups_.empty(); }
  [[nodiscard]] bool is_of_groups() const { return !groups_.empty(); }

 private:
  enum class Comparison { less, at_most, more, at_least, equal };
  struct Condition {
    std::optional<GaussianAttribute> field;  // nullopt: the id
    Comparison comparison;
    double value;
  };
  std::vector<Condition> conditions_;
  std::vector<QString> groups_;  // names in lower case
};

}  // namespace brume
