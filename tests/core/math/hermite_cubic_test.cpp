#include "core/math/hermite_cubic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace brume {
namespace {

// The cubic in powers of x, from its four conditions.
double in_powers(const HermiteCubic& c, double x) {
  const double h = c.length;
  const double second =
      (3.0 * (c.end - c.begin) - h * (2.0 * c.begin_slope + c.end_slope)) / (h * h);
  const double third = (2.0 * (c.begin - c.end) + h * (c.begin_slope + c.end_slope)) / (h * h * h);
  return c.begin + x * (c.begin_slope + x * (second + x * third));
}

class RandomCubics {
 public:
  HermiteCubic next() {
    return {0.1 + 3.0 * number(), number(), number(), 30.0 * number() - 15.0,
            30.0 * number() - 15.0};
  }
  double number() { return uniform_(random_); }

 private:
  std::mt19937_64 random_{7};
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

TEST(HermiteCubic, IsThePolynomialOfItsEnds) {
  RandomCubics cubics;
  for (int round = 0; round < 200; ++round) {
    const HermiteCubic cubic = cubics.next();
    EXPECT_EQ(cubic.value(0.0), cubic.begin);
    for (double x = 0.0; x < cubic.length; x += 0.1) {
      const double value = cubic.value(x);
      ASSERT_NEAR(value, in_powers(cubic, x), 1e-12);
      ASSERT_GE(value, cubic.lower_bound() - 1e-12);
      ASSERT_LE(value, cubic.upper_bound() + 1e-12);
    }
  }
}

// Against sums of many values; the midpoint rule errs by (length / count)^2 times the slope.
TEST(HermiteCubic, IntegralsAreSums) {
  RandomCubics cubics;
  int clipped = 0;
  for (int round = 0; round < 60; ++round) {
    const HermiteCubic cubic = cubics.next();
    double low = cubic.length * cubics.number();
    double high = cubic.length * cubics.number();
    if (low > high) std::swap(low, high);
    constexpr int count = 20'000;
    double sum = 0.0;
    double sum_above = 0.0;
    for (int k = 0; k < count; ++k) {
      const double value = in_powers(cubic, std::lerp(low, high, (k + 0.5) / count));
      sum += value * (high - low) / count;
      sum_above += std::max(value, 0.0) * (high - low) / count;
    }
    if (sum_above > sum + 1e-3) ++clipped;
    ASSERT_NEAR(cubic.integral(low, high), sum, 1e-6);
    ASSERT_NEAR(cubic.integral_above(0.0, low, high), sum_above, 1e-6);
  }
  EXPECT_GT(clipped, 10);
}

TEST(HermiteCubic, IntegralsAboveAFloorOfStraightLinesAndParabolas) {
  const HermiteCubic line{2.0, -1.0, 1.0, 1.0, 1.0};
  EXPECT_NEAR(line.integral_above(0.0, 0.0, 2.0), 0.5, 1e-12);
  const HermiteCubic parabola{2.0, 1.0, 1.0, -4.0, 4.0};  // 1 - 4 x + 2 x^2, -1 at x = 1
  const double root = 1.0 - std::sqrt(0.5);
  const double side = root - 2.0 * root * root + 2.0 / 3.0 * root * root * root;
  EXPECT_NEAR(parabola.integral_above(0.0, 0.0, 2.0), 2.0 * side, 1e-12);
  EXPECT_NEAR(parabola.integral_above(0.0, 0.9, 1.1), 0.0, 1e-12);
  EXPECT_EQ(parabola.integral_above(0.0, 0.5, 0.5), 0.0);
}

}  // namespace
}  // namespace brume
