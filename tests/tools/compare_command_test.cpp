#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/io/image/image_file.h"
#include "render/output/compare.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

using Json = nlohmann::json;

TEST_F(CommandLine, ComparesAgainstTheSecondImage) {
  write_image("a.exr", {{"R", 1}, {"G", 2}, {"B", 6}, {"Z", 2}});
  write_image("b.exr", {{"R", 1}, {"G", 4}, {"B", 3}, {"Z", 4}});
  const ProgramResult result = expect_done({"compare", file("a.exr"), file("b.exr")});
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
  const Json json = Json::parse(result.out);
  EXPECT_DOUBLE_EQ(json["rel_rmse"], std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(json["max_error"], 3.0);
  EXPECT_DOUBLE_EQ(json["bias"], 0.125);

  const auto with = [&](const char* option, const char* value) {
    return run_brume({"compare", file("a.exr"), file("b.exr"), option, value});
  };
  EXPECT_DOUBLE_EQ(Json::parse(with("--layer", "Z").out)["bias"], -0.5);
  EXPECT_EQ(with("--max-rel-rmse", "0.7").exit_code, 1);
  EXPECT_EQ(with("--max-rel-rmse", "0.71").exit_code, 0);
  EXPECT_EQ(Json::parse(with("--max-rel-rmse", "0").out), json);
}

TEST_F(CommandLine, CompareStatesWhatCannotBeCompared) {
  const float infinity = std::numeric_limits<float>::infinity();
  write_image("a.exr", {{"R", 1}, {"G", 2}, {"B", std::nanf("")}, {"Z", infinity}});
  write_image("b.exr", {{"R", 1}, {"G", 2}, {"B", 3}, {"Z", infinity}});
  const ProgramResult result = run_brume({"compare", file("a.exr"), file("b.exr")});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(Json::parse(result.out)["rel_rmse"].is_null());
  EXPECT_TRUE(contains(result.err, "NaN"));
  const ProgramResult depth =
      expect_done({"compare", file("a.exr"), file("b.exr"), "--layer", "Z"});
  EXPECT_EQ(Json::parse(depth.out)["rel_rmse"], 0.0);
}

// The same colour, as ACEScg and as Rec. 709 have it.
TEST_F(CommandLine, ComparesColoursOfOtherPrimaries) {
  const auto write = [&](const char* name, const char* color, const char* chromaticities) {
    const std::string command = quoted(BRUME_OIIOTOOL) + " --pattern constant:color=" + color +
                                " 4x4 3 --attrib:type='float[8]' chromaticities " + chromaticities +
                                " -d float -o " + quoted(file(name));
    EXPECT_EQ(std::system(command.c_str()), 0);
  };
  write("a.exr", "0.7947038,0.5317338,0.2928541",
        "0.713,0.293,0.165,0.83,0.128,0.044,0.32168,0.33767");
  write("b.exr", "1,0.5,0.25", "0.64,0.33,0.3,0.6,0.15,0.06,0.3127,0.329");
  const ProgramResult result = expect_done({"compare", file("a.exr"), file("b.exr")});
  EXPECT_LT(Json::parse(result.out)["max_error"], 1e-5);
}

TEST_F(CommandLine, RefusesWhatHasNothingToCompare) {
  write_image("a.exr", {{"R", 1}, {"G", 2}, {"B", 3}});
  write_image("z.exr", {{"Z", 1}});
  ImageLayers wide;
  wide.width = 2;
  wide.height = 1;
  for (const char* name : {"R", "G", "B"}) wide.channels[name] = {1, 2};
  write_exr(folder_ / "wide.exr", wide);
  folder_.write("not.exr", "hello");
  expect_refused({"compare", file("a.exr"), file("wide.exr")}, {"a.exr", "1 x 1", "2 x 1"});
  expect_refused({"compare", file("a.exr"), file("z.exr")}, {"z.exr", "no channels R G B"});
  expect_refused({"compare", file("z.exr"), file("a.exr")}, {"z.exr", "no channels R G B"});
  expect_refused({"compare", file("a.exr"), file("a.exr"), "--layer", "fog"}, {"fog", "R"});
  expect_refused({"compare", file("a.exr"), file("not.exr")}, {"not.exr", "OpenEXR"});
  expect_refused({"compare", file("a.exr"), file("none.exr")}, {"none.exr", "no such file"});
  expect_refused({"compare", file("a.exr")}, {"B"});
}

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
