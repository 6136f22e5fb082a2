#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/io/gaussians/gaussian_file.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

using Json = nlohmann::json;

TEST_F(CommandLine, SummarizesAScene) {
  const ProgramResult result = expect_done({"info", scene_, "--json"});
  const Json info = Json::parse(result.out);
  EXPECT_EQ(info["medium"]["gaussians"], 2);
  EXPECT_EQ(info["medium"]["homogeneous_density"], 0.02);
  EXPECT_EQ(info["medium"]["center_bounds"], Json::parse("[[0, 0, 0], [1, 0, 0]]"));
  EXPECT_EQ(info["medium"]["bounds"], Json::parse("[[-2, -2, -2], [2, 2, 2]]"));
  EXPECT_EQ(info["medium"]["radius_range"], Json::parse("[0.5, 1]"));
  EXPECT_DOUBLE_EQ(info["medium"]["peak_density"], 0.02 + 2.0 + 0.5 * std::exp(-1.0));
  EXPECT_EQ(info["film"], Json::parse("[24, 18]"));
  EXPECT_EQ(info["lights"].size(), 1u);
  EXPECT_EQ(info["surfaces"][0]["vertices"], 4);
  EXPECT_EQ(info["surfaces"][0]["faces"], 2);
  // The line through both centres sees both whole; 64 directions come near it.
  const double both = std::sqrt(std::acos(-1.0)) * (1.0 * 0.5 + 0.5 * 2.0);
  EXPECT_LE(info["medium"]["greatest_optical_depth"], both);
  EXPECT_GT(info["medium"]["greatest_optical_depth"], 0.95 * both);

  const ProgramResult words = expect_done({"info", scene_});
  EXPECT_TRUE(contains(words.out, "gaussians: 2", "center bounds: (0, 0, 0) to (1, 0, 0)"));
}

// Fog over a wide ground, as far as that reaches.
TEST_F(CommandLine, SaysHowMuchOfTheSunDeepFogLetsThrough) {
  const std::string scene = folder_.write_scene(
      "deep.brume", R"("camera": {"eye": [0, 2, 4], "target": [0, 0, 0], "vertical_fov": 40},
    "film": {"width": 4, "height": 3}, "medium": {"density": 0.05},
    "lights": [{"type": "directional", "direction": [0, -1, 0], "irradiance": [1, 1, 1]}],
    "surfaces": [{"primitive": {"type": "plane", "size": [60, 1, 80]}}])");
  const Json info = Json::parse(expect_done({"info", scene, "--json"}).out);
  EXPECT_DOUBLE_EQ(info["medium"]["far_light_transmittance"], std::exp(-5.0));
  EXPECT_DOUBLE_EQ(info["medium"]["fog_extent"], 100.0);
  EXPECT_EQ(info["medium"]["fog_extent_is"], "derived");
  const ProgramResult render =
      expect_done({"render", scene, "-o", file("deep.exr"), "--error", "none"});
  for (const std::string& err : {render.err, expect_done({"info", scene}).err}) {
    EXPECT_TRUE(contains(err, "lets 0.67% of the light from far away through"));
    EXPECT_TRUE(
        contains(err,
                 "as far as all that is in the scene; a homogeneous density of 0.0069, or a "
                 "medium.extent of 14, would let half of it through"));
  }
}

TEST_F(CommandLine, SaysHowFarFogReaches) {
  const auto scene = [this](const char* name, const std::string& medium, const char* type) {
    return folder_.write(name, R"({"format": "brume-scene", "version": 1,
    "camera": {"eye": [0, 2, 4], "target": [0, 0, 0]}, "film": {"width": 4, "height": 3},
    "medium": {)" + medium + R"(}, "lights": [)" +
                                   type + "]}");
  };
  const char* const sun = R"({"type": "directional", "direction": [0, -1, 0],
                              "irradiance": [1, 1, 1]})";
  const char* const point = R"({"type": "point", "position": [0, 3, 0], "intensity": [1, 1, 1]})";
  const auto info_of = [this](const std::string& file) {
    return Json::parse(expect_done({"info", file, "--json"}).out)["medium"];
  };
  const std::string set = R"("density": 0.05, "extent": 30)";
  const Json far = info_of(scene("far.brume", set, sun));
  EXPECT_DOUBLE_EQ(far["fog_extent"], 30.0);
  EXPECT_EQ(far["fog_extent_is"], "set");
  EXPECT_DOUBLE_EQ(far["far_light_transmittance"], std::exp(-1.5));
  const ProgramResult warned = expect_done({"info", scene("far.brume", set, sun)});
  EXPECT_TRUE(contains(warned.err,
                       "it reaches 30 u, the medium's extent; a homogeneous density of 0.023, "
                       "or a medium.extent of 14, would"));
  const Json near = info_of(scene("near.brume", set, point));
  EXPECT_DOUBLE_EQ(near["fog_extent"], 30.0);
  EXPECT_FALSE(near.contains("far_light_transmittance"));
  const Json endless = info_of(scene("endless.brume", R"("density": 0.05)", point));
  EXPECT_EQ(endless["fog_extent_is"], "endless");
  EXPECT_FALSE(endless.contains("fog_extent"));
  EXPECT_FALSE(info_of(scene("clear.brume", "", point)).contains("fog_extent_is"));
}

TEST_F(CommandLine, SummarizesAMedium) {
  write_gaussians(folder_ / "m.ply", std::vector<Gaussian>{{{1, 2, 3}, 2, 0.25}});
  const ProgramResult result = expect_done({"info", file("m.ply"), "--json"});
  const Json medium = Json::parse(result.out)["medium"];
  EXPECT_EQ(medium["gaussians"], 1);
  EXPECT_DOUBLE_EQ(medium["greatest_optical_depth"], std::sqrt(std::acos(-1.0)) * 0.5);
}

TEST_F(CommandLine, AcceptsExtensionsInAnyCase) {
  write_gaussians(folder_ / "M.PLY", std::vector<Gaussian>{{{1, 2, 3}, 2, 0.25}});
  expect_done({"info", file("M.PLY")});
  expect_done({"info", folder_.write("A.Brume", scene_text)});
  expect_refused({"info", file("smoke.VDB")}, {"smoke.VDB", "no such file"});
}

}  // namespace
}  // namespace brume
