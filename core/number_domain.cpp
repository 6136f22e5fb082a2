#include "core/number_domain.h"

#include <array>
#include <charconv>

namespace brume {

std::string quoted_text(double value) {
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

std::string NumberDomain::refusal(double value) const {
  return "found " + quoted_text(value) + "; allowed: " + allowed;
}

std::string refused_radii(const glm::dvec3& radii) {
  const auto [least, greatest] = std::minmax({radii.x, radii.y, radii.z});
  constexpr double rounding = 1e-12;  // of numbers with a few digits less, and of products
  if (least >= limits::min_stretch * greatest * (1.0 - rounding)) return {};
  std::string why = "found ";
  why.append(quoted_text(least)).append(" beside ").append(quoted_text(greatest));
  return why.append("; allowed: radii of at least 1e-4 of the greatest");
}

}  // namespace brume
