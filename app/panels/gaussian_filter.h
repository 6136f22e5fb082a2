#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/document/gaussian_attribute.h"

namespace brume {

// A conjunction of conditions on a Gaussian's attributes: "radius < 0.5, density > 0.2".
class GaussianFilter {
 public:
  // Conditions are separated by commas or "and"; fields are x, y, z, radius, density, albedo and
  // emission, or as many of their letters as tell them apart; comparisons are < <= > >= =. Empty
  // text lets all pass. nullopt where the text is something else; `problem` then says what.
  static std::optional<GaussianFilter> parse(const QString& text, QString& problem);

  [[nodiscard]] bool passes(const Gaussian& gaussian) const;
  [[nodiscard]] bool is_empty() const { return conditions_.empty(); }

 private:
  enum class Comparison { less, at_most, more, at_least, equal };
  struct Condition {
    GaussianAttribute field;
    Comparison comparison;
    double value;
  };
  std::vector<Condition> conditions_;
};

}  // namespace brume
