#include "render/output/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brume {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

Comparison compare_one(const std::vector<float>& a, const std::vector<float>& b) {
  return compare(std::vector<ChannelPair>{{a, b}});
}

TEST(Compare, MeasuresAAgainstB) {
  const Comparison result = compare_one({1, 2, 6}, {1, 4, 3});
  EXPECT_DOUBLE_EQ(result.rel_rmse, std::sqrt(13.0 / 26.0));
  EXPECT_DOUBLE_EQ(result.max_error, 3.0);
  EXPECT_DOUBLE_EQ(result.bias, 1.0 / 8.0);
  EXPECT_EQ(result.incomparable, 0u);
}

TEST(Compare, CombinesAllChannels) {
  const std::vector<float> ones{1, 1};
  const std::vector<float> threes{3, 3};
  const Comparison result = compare(std::vector<ChannelPair>{{ones, ones}, {threes, ones}});
  EXPECT_DOUBLE_EQ(result.rel_rmse, std::sqrt(8.0 / 4.0));
  EXPECT_DOUBLE_EQ(result.bias, 1.0);
}

TEST(Compare, EqualInfinitiesAreNoDifference) {
  const Comparison result = compare_one({infinity, 2}, {infinity, 1});
  EXPECT_DOUBLE_EQ(result.rel_rmse, 1.0);
  EXPECT_EQ(result.incomparable, 0u);
}

TEST(Compare, CountsWhatCannotBeCompared) {
  const float nan = std::nanf("");
  EXPECT_EQ(compare_one({nan, 1, infinity, 1, infinity}, {1, nan, 1, 1, -infinity}).incomparable,
            4u);
}

TEST(Compare, AgainstNothing) {
  EXPECT_EQ(compare_one({0}, {0}).rel_rmse, 0.0);
  EXPECT_EQ(compare_one({1}, {0}).rel_rmse, std::numeric_limits<double>::infinity());
}

TEST(Compare, FindsLayers) {
  ImageLayers image;
  for (const char* name : {"R", "G", "B", "Z", "fog.R", "fog.G", "fog.B", "half.R"}) {
    image.channels[name] = {};
  }
  EXPECT_EQ(layer_channels(image, ""), (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(layer_channels(image, "fog"), (std::vector<std::string>{"fog.R", "fog.G", "fog.B"}));
  EXPECT_EQ(layer_channels(image, "Z"), (std::vector<std::string>{"Z"}));
  EXPECT_TRUE(layer_channels(image, "half").empty());
}

}  // namespace
}  // namespace brume
