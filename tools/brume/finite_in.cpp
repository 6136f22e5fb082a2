#include "tools/brume/finite_in.h"

#include "core/io/text_scanner.h"
#include "core/number_domain.h"

namespace brume {

CLI::Validator finite_in(double low, double high) {
  const std::string range = "from " + quoted_text(low) + " to " + quoted_text(high);
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        double value = 0.0;
        // NaN is in no range.
        if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
        return "found " + quoted_text(text) + "; allowed: a number " + range;
      },
      range);
}

}  // namespace brume
