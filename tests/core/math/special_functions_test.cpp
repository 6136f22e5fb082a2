#include "core/math/special_functions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brume {
namespace {

// Of tables, and integrated.
TEST(EntireExponentialIntegral, IsItsIntegral) {
  EXPECT_EQ(entire_exponential_integral(0.0), 0.0);
  EXPECT_NEAR(entire_exponential_integral(1e-6), 1e-6, 1e-12);
  EXPECT_NEAR(entire_exponential_integral(1.0), 0.796599599297053, 1e-12);
  for (const double x : {0.3, 5.0, 17.9, 18.1, 40.0}) {
    double sum = 0.0;
    constexpr int steps = 200000;
    for (int i = 0; i < steps; ++i) {
      const double t = x * (i + 0.5) / steps;
      sum += -std::expm1(-t) / t * x / steps;
    }
    EXPECT_NEAR(entire_exponential_integral(x), sum, 2e-8 * sum) << x;
  }
}

}  // namespace
}  // namespace brume
