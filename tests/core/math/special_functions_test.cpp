#include "core/math/special_functions.h"
#include "core/math/hermite_cubic.h"
#include "core/math/rounded.h"
#include "core/math/substantial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

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

TEST(Rounded, IsTheNearestOfAsManyDigits) {
  EXPECT_EQ(rounded(0.123456, 3), 0.123);
  EXPECT_EQ(rounded(-0.0099999, 2), -0.01);
  EXPECT_EQ(rounded(98765.0, 2), 99000.0);
  EXPECT_EQ(rounded(0.1, 17), 0.1);
  EXPECT_EQ(rounded(0.0, 4), 0.0);
}

TEST(Rounded, KeepsWhatNoDoubleWouldHold) {
  constexpr double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(rounded(largest, 1), largest);  // 2e308 is none
}

// The Gaussians by which the extent of a medium is measured.

GaussianExtent at(double x, double depth) {
  return {{x - 1.0, -1.0, -1.0}, {x + 1.0, 1.0, 1.0}, depth};
}

using Indices = std::vector<std::size_t>;

TEST(SubstantialGaussians, AThinOneFarAwayDoesNotCount) {
  EXPECT_EQ(substantial_gaussians(std::vector{at(0, 1.0), at(100, 0.002), at(1, 0.5)}),
            (Indices{0, 2}));
}

TEST(SubstantialGaussians, ThinOnesCountAmongTheOthers) {
  EXPECT_EQ(substantial_gaussians(std::vector{at(0, 1.0), at(0.5, 0.002)}), (Indices{0, 1}));
}

TEST(SubstantialGaussians, ThinOnesAreThinTogether) {
  std::vector<GaussianExtent> gaussians{at(0, 1.0)};
  for (int i = 0; i < 6; ++i) gaussians.push_back(at(100, 0.002));
  EXPECT_EQ(substantial_gaussians(gaussians).size(), 7u);
}

TEST(SubstantialGaussians, ThinOnesCountIfAllAreThin) {
  EXPECT_EQ(substantial_gaussians(std::vector{at(0, 0.004), at(100, 0.002)}), (Indices{0, 1}));
}

TEST(SubstantialGaussians, ThoseThatEmitCount) {
  std::vector<GaussianExtent> gaussians{at(0, 1.0), at(100, 0.002)};
  gaussians[1].emits = true;
  EXPECT_EQ(substantial_gaussians(gaussians), (Indices{0, 1}));
}

TEST(SubstantialGaussians, NoneAreNone) {
  EXPECT_TRUE(substantial_gaussians({}).empty());
  EXPECT_EQ(substantial_gaussians(std::vector{at(0, 0.0), at(9, 0.0)}), (Indices{0, 1}));
}

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
