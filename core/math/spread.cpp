#include "core/math/spread.h"

#include <algorithm>
#include <cstddef>

namespace brume {

Spread spread_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t center = values.size() / 2;
  const double median =
      values.size() % 2 == 1 ? values[center] : 0.5 * (values[center - 1] + values[center]);
  return {median, values.front(), values.back()};
}

}  // namespace brume
