#include "core/math/rounded.h"

#include <gtest/gtest.h>

#include <limits>

namespace brume {
namespace {

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

}  // namespace
}  // namespace brume
