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

}  // namespace brume
