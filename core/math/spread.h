#pragma once

#include <vector>

namespace brume {

// Median and spread of something measured several times.
struct Spread {
  double median = 0.0;
  double min = 0.0;
  double max = 0.0;
};
// At least one value.
Spread spread_of(std::vector<double> values);

}  // namespace brume
