#include "render/display/to_display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/math/srgb.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/render/display/halving_config.h"

namespace brume {
namespace {

Frame grey_frame(const Film& film, const std::vector<float>& greys) {
  Frame frame;
  frame.film = film;
  for (const float grey : greys) {
    frame.beauty.insert(frame.beauty.end(), {grey, grey, grey, 1.0f});
  }
  return frame;
}

// Rows of a dim glow, of 9 levels of 8 bits, the same in each row.
Frame glow(int width, int height) {
  std::vector<float> greys;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      greys.push_back(0.02f + 0.02f * static_cast<float>(x) / static_cast<float>(width));
    }
  }
  return grey_frame({width, height}, greys);
}

// Values of a display that a view of a configuration shows as they are.
DisplayLook look_of_values(const TemporaryFolder& folder) {
  const std::string config = folder.write("config.ocio", halving_config).string();
  return {0.0, std::make_shared<ColorView>(ColorChoice{config, "screen", "plain"})};
}

TEST(ToDisplay, EightBitsHaveTheMeanOfTheLight) {
  constexpr int width = 960;
  constexpr int height = 16;
  const Frame frame = glow(width, height);
  const std::vector<std::uint8_t> bytes = to_display(frame, {});
  const std::vector<std::uint16_t> fine = to_display_16(frame, {});
  ASSERT_EQ(bytes.size(), fine.size());
  double bias = 0.0;
  for (int first = 0; first < width; first += height) {
    double difference = 0.0;
    for (int y = 0; y < height; ++y) {
      for (int x = first; x < first + height; ++x) {
        const auto i = static_cast<std::size_t>(3 * (y * width + x));
        const double error = bytes[i] - fine[i] / 257.0;
        EXPECT_LT(std::abs(error), 1.0);
        EXPECT_EQ(bytes[i], bytes[i + 1]);  // grey stays grey
        difference += error / (height * height);
      }
    }
    // 256 thresholds are spread evenly; rounding alone is off by up to half a level.
    EXPECT_LT(std::abs(difference), 0.04) << first;
    bias += difference / (width / height);
  }
  EXPECT_LT(std::abs(bias), 0.004);
}

TEST(ToDisplay, DimGlowsHaveNoFlatBands) {
  constexpr int width = 960;
  const std::vector<std::uint8_t> bytes = to_display(glow(width, 1), {});
  int longest = 0;
  for (int x = 1, run = 1; x < width; ++x) {
    run = bytes[static_cast<std::size_t>(3 * x)] == bytes[static_cast<std::size_t>(3 * x - 3)]
              ? run + 1
              : 1;
    longest = std::max(longest, run);
  }
  // A level is 100 pixels wide; within a tenth of it few thresholds decide.
  EXPECT_LT(longest, 30);
}

TEST(ToDisplay, LevelsAreNotDithered) {
  const TemporaryFolder folder;
  const DisplayLook look = look_of_values(folder);
  constexpr int side = 32;
  for (int level = 0; level < 256; ++level) {
    const float value = static_cast<float>(level) / 255.0f;
    const std::vector<float> greys(side * side, value);
    const std::vector<std::uint8_t> bytes = to_display(grey_frame({side, side}, greys), look);
    EXPECT_EQ(std::ranges::count(bytes, level), 3 * side * side) << level;
  }
  for (const float grey : {0.0f, 1e30f}) {
    const std::vector<std::uint8_t> bytes =
        to_display(grey_frame({side, side}, std::vector<float>(side * side, grey)), {});
    EXPECT_EQ(std::ranges::count(bytes, grey > 0.0f ? 255 : 0), 3 * side * side);
  }
}

TEST(ToDisplay, RegionsHaveThePatternOfTheWhole) {
  constexpr int width = 40;
  constexpr int left = 7;
  constexpr int top = 5;
  Frame whole = glow(width, 12);
  Frame part;
  part.film = {20, 4, FilmRegion{left, top, width, 12}};
  std::vector<std::uint8_t> expected;
  const std::vector<std::uint8_t> bytes = to_display(whole, {});
  for (int y = top; y < top + part.film.height; ++y) {
    const std::ptrdiff_t first = y * width + left;
    const std::ptrdiff_t last = first + part.film.width;
    part.beauty.insert(part.beauty.end(), whole.beauty.begin() + 4 * first,
                       whole.beauty.begin() + 4 * last);
    expected.insert(expected.end(), bytes.begin() + 3 * first, bytes.begin() + 3 * last);
  }
  EXPECT_EQ(to_display(part, {}), expected);
}

TEST(ToDisplay, SixteenBitsAreRounded) {
  const TemporaryFolder folder;
  const std::vector<float> greys{0.0f, 0.3f, 0.5f, 1.0f};
  const std::vector<std::uint16_t> values =
      to_display_16(grey_frame({4, 1}, greys), look_of_values(folder));
  for (std::size_t i = 0; i < greys.size(); ++i) {
    EXPECT_EQ(values[3 * i], std::lround(65535.0f * greys[i])) << greys[i];
  }
  // The neutral view takes 0.04 away.
  for (const float grey : {0.081f, 0.2f, 0.5f, 0.75f}) {
    EXPECT_NEAR(to_display_16(grey_frame({1, 1}, {grey}), {})[0],
                65535.0f * srgb_encoded(grey - 0.04f), 1.0f)
        << grey;
  }
}

}  // namespace
}  // namespace brume
