#include "core/math/special_functions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brume {
namespace {

// The values are those of tables, and of the integral.
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

TEST(SpecialFunctions, Dawson) {
  EXPECT_EQ(dawson(0.0), 0.0);
  // Abramowitz and Stegun, table 7.5.
  EXPECT_NEAR(dawson(0.1), 0.0993359924, 1e-9);
  EXPECT_NEAR(dawson(1.0), 0.5380795069, 2e-7);
  EXPECT_NEAR(dawson(2.0), 0.3013403889, 2e-7);
  for (const double x : {0.19999, 0.20001, 0.9, 3.3, 12.0}) {
    double sum = 0.0;
    constexpr int steps = 200000;
    for (int i = 0; i < steps; ++i) {
      const double t = x * (i + 0.5) / steps;
      sum += std::exp((t - x) * (t + x)) * x / steps;
    }
    EXPECT_NEAR(dawson(x), sum, 1e-6 * sum) << x;
  }
}

}  // namespace
}  // namespace brume
