#include "render/display/to_display.h"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "brume/error.h"
#include "core/math/srgb.h"
#include "render/display/color_view.h"
#include "tests/contains.h"
#include "tests/core/io/folder_test.h"
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

std::array<float, 3> shown(const ColorView& view, std::array<float, 3> rgb) {
  view.apply(rgb);
  return rgb;
}

float srgb(float x) {
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

std::string refusal(const ColorChoice& choice) {
  try {
    const ColorView view(choice);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

using ColorViews = FolderTest;

TEST_F(ColorViews, AcesHasDisplaysAndViews) {
  const std::vector<ColorDisplay> displays = color_displays(aces_config);
  ASSERT_EQ(displays.size(), 2u);
  EXPECT_EQ(displays[0].name, "sRGB");
  EXPECT_EQ(displays[0].views, (std::vector<std::string>{"ACES 1.0 SDR", "Un-tone-mapped"}));
  const ColorView view({aces_config, "", ""});
  EXPECT_EQ(view.choice(), (ColorChoice{aces_config, "sRGB", "ACES 1.0 SDR"}));
}

// To ACES2065-1 and back: the way in and out agree, primaries and white included.
TEST_F(ColorViews, UntouchedColoursAreEncodedOnly) {
  const ColorView view({aces_config, "sRGB", "Un-tone-mapped"});
  for (const std::array<float, 3> rgb : {std::array{0.0f, 0.0f, 0.0f},
                                         {1.0f, 1.0f, 1.0f},
                                         {0.8f, 0.1f, 0.1f},
                                         {0.1f, 0.7f, 0.2f},
                                         {0.05f, 0.1f, 0.9f}}) {
    const std::array<float, 3> found = shown(view, rgb);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], srgb(rgb[c]), 2e-3f) << rgb[0];
  }
}

// ACES 1.0 shows middle grey, 0.18, as a tenth of its white (4.8 of 48 nits in the cinema), rolls
// off what is brighter, and takes strong lights towards white.
TEST_F(ColorViews, AcesIsAces) {
  const ColorView view({aces_config, "sRGB", "ACES 1.0 SDR"});
  EXPECT_NEAR(shown(view, {0.18f, 0.18f, 0.18f})[1], srgb(0.1f), 0.01f);
  float last = -1.0f;
  for (float x = 0.0f; x < 40.0f; x = 1.5f * x + 0.01f) {
    const float y = shown(view, {x, x, x})[0];
    EXPECT_GE(y, last);
    EXPECT_LE(y, 1.01f);  // as the view has it; to_display() clamps
    last = y;
  }
  EXPECT_GT(last, 0.97f);
  EXPECT_GT(shown(view, {100.0f, 1.0f, 1.0f})[1], shown(view, {1.0f, 0.01f, 0.01f})[1]);
}

TEST_F(ColorViews, ReadsAConfiguration) {
  const std::string config = folder_.write("config.ocio", halving_config).string();
  EXPECT_EQ(shown(ColorView({config, "screen", "half"}), {0.8f, 0.4f, 0.2f}),
            (std::array{0.4f, 0.2f, 0.1f}));
  EXPECT_EQ(refusal({config, "tv", ""}), config + ": found the display tv; allowed: screen");
  EXPECT_EQ(refusal({config, "screen", "x"}),
            config + ": found the view x of screen; allowed: plain, half");
}

TEST_F(ColorViews, BadConfigurationsAreRefusedInOneLine) {
  for (const std::string& text :
       {std::string(""), std::string("ocio_profile_version: 9"), std::string("{{{"),
        std::string("ocio_profile_version: 1\ndisplays: {}\n"), std::string(100'000, '[')}) {
    const std::string config = folder_.write("bad.ocio", text).string();
    const std::string found = refusal({config, "", ""});
    EXPECT_TRUE(found.starts_with(config + ": ")) << found;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
  }
  EXPECT_NE(refusal({(folder_ / "none.ocio").string(), "", ""}), "");
}

// Rec. 709 goes by ACES2065-1 where a configuration has no name for it; views of data do not.
TEST_F(ColorViews, ViewsOfDataConvertNothing) {
  const std::string config = folder_
                                 .write("config.ocio", R"(ocio_profile_version: 2
roles:
  default: Linear
  scene_linear: Linear
  aces_interchange: ACES
displays:
  sRGB:
    - !<View> {name: Raw, colorspace: Raw}
    - !<View> {name: Linear, colorspace: Linear}
colorspaces:
  - !<ColorSpace>
    name: Linear
  - !<ColorSpace>
    name: ACES
    from_scene_reference: !<MatrixTransform> {matrix: [0.4396,0.3830,0.1774,0, 0.0898,0.8134,0.0968,0, 0.0175,0.1115,0.8709,0, 0,0,0,1]}
  - !<ColorSpace>
    name: Raw
    isdata: true
)")
                                 .string();
  EXPECT_EQ(shown(ColorView({config, "sRGB", "Raw"}), {1.0f, 0.5f, 0.25f}),
            (std::array{1.0f, 0.5f, 0.25f}));
  const std::array<float, 3> linear =
      shown(ColorView({config, "sRGB", "Linear"}), {1.0f, 0.5f, 0.25f});
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(linear[c], (std::array{1.0f, 0.5f, 0.25f})[c], 2e-3f);  // four digits above
  }
}

// A role of nothing, a look without its file, and a view that needs it.
constexpr const char* incomplete_config = R"(ocio_profile_version: 1
search_path: "luts"
roles:
  reference: linear
  XYZ: none
displays:
  screen:
    - !<View> {name: plain, colorspace: linear}
    - !<View> {name: curved, colorspace: curved}
    - !<View> {name: broken, colorspace: linear, looks: gone}
active_displays: [screen, none]
colorspaces:
  - !<ColorSpace>
    name: linear
  - !<ColorSpace>
    name: curved
    from_reference: !<FileTransform> {src: curve.spi1d, interpolation: linear}
looks:
  - !<Look>
    name: gone
    process_space: linear
    transform: !<FileTransform> {src: gone.spi1d, interpolation: linear}
)";

TEST_F(ColorViews, ComplaintsAboutOtherViewsAreWarnings) {
  const std::string config = folder_.write("config.ocio", incomplete_config).string();
  const ColorView view({config, "screen", "plain"});
  EXPECT_EQ(shown(view, {0.8f, 0.4f, 0.2f}), (std::array{0.8f, 0.4f, 0.2f}));
  ASSERT_EQ(view.warnings().size(), 1u);
  EXPECT_TRUE(view.warnings()[0].starts_with(config + ": OpenColorIO says: "));
  EXPECT_EQ(view.warnings()[0].find('\n'), std::string::npos);
  EXPECT_EQ(color_displays(config).size(), 1u);
  EXPECT_TRUE(contains(refusal({config, "screen", "broken"}), "gone.spi1d"));
  EXPECT_TRUE(ColorView({aces_config, "", ""}).warnings().empty());
}

TEST_F(ColorViews, FilesAreTheConfigurationAndItsLuts) {
  const std::string config = folder_.write("config.ocio", incomplete_config).string();
  const std::filesystem::path lut = folder_.write(
      "luts/curve.spi1d", "Version 1\nFrom 0.0 1.0\nLength 2\nComponents 1\n{\n0.0\n0.5\n}\n");
  using Files = std::vector<std::filesystem::path>;
  EXPECT_EQ(ColorView({config, "screen", "plain"}).files(), Files{config});
  EXPECT_EQ(ColorView({config, "screen", "curved"}).files(), (Files{config, lut}));
  EXPECT_TRUE(ColorView({aces_config, "", ""}).files().empty());
}

TEST_F(ColorViews, ConfigurationsOfOpenColorIoNeedItsVersion) {
  const std::string found = refusal({"ocio://default", "", ""});
  EXPECT_TRUE(found.empty() || found.find("needs OpenColorIO 2.2 or newer") != std::string::npos)
      << found;
  EXPECT_NE(refusal({"ocio://none", "", ""}), "");
}

// OpenColorIO would wait for the other end of a pipe, wherever a configuration names it.
TEST_F(ColorViews, RefusesPipesInPlaceOfItsFiles) {
  ASSERT_EQ(::mkfifo((folder_ / "lut.spi1d").c_str(), 0600), 0);
  const std::string lut = "!<FileTransform> {src: lut.spi1d}";
  const std::string group = "!<GroupTransform> {children: [" + lut + "]}";
  for (const std::string& more :
       {"  - !<ColorSpace> {name: x, to_reference: " + lut + "}\n",
        "  - !<ColorSpace> {name: x, from_reference: " + group + "}\n",
        "looks:\n  - !<Look> {name: x, process_space: linear, transform: " + group + "}\n"}) {
    const std::string config =
        folder_.write("a.ocio", halving_config + more + "search_path: .\n").string();
    EXPECT_EQ(refusal({config, "screen", "half"}),
              (folder_ / "lut.spi1d").string() + ": is not a regular file")
        << more;
  }
  const std::string config = folder_.write("a.ocio", halving_config).string();
  EXPECT_EQ(refusal({config, "screen", "half"}), "");
}

TEST(ToDisplay, ShowsAFrameInAView) {
  Frame frame;
  frame.film = {2, 1};
  frame.beauty = {0.18f, 0.18f, 0.18f, 1.0f, 1e30f, 0.0f, 0.0f, 1.0f};
  DisplayLook look;
  look.view = std::make_shared<ColorView>(ColorChoice{aces_config, "sRGB", "Un-tone-mapped"});
  const std::vector<std::uint8_t> bytes = to_display(frame, look);
  ASSERT_EQ(bytes.size(), 6u);
  EXPECT_NEAR(bytes[0], 255.0f * srgb(0.18f), 1.0f);
  EXPECT_EQ(bytes[3], 255);
  look.exposure = 1.0;
  EXPECT_NEAR(to_display(frame, look)[1], 255.0f * srgb(0.36f), 1.0f);
  EXPECT_EQ(view_name(look), "Un-tone-mapped, sRGB");
  EXPECT_EQ(view_name({}), "Khronos PBR Neutral, sRGB");
}

}  // namespace

}  // namespace brume
