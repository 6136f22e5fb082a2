// brume export to USD: the stage, and its volumes beside it.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/io/volume/volume_file.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

class UsdExport : public CommandLine {
 protected:
  [[nodiscard]] std::string text_of(const char* name) const {
    std::ifstream in(file(name));
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
};

TEST_F(UsdExport, WritesAStageAndItsVolume) {
  const ProgramResult result = expect_done({"export", scene_, "-o", file("a.usda")});
  EXPECT_TRUE(contains(result.err, "homogeneous"));
  const std::string stage = text_of("a.usda");
  EXPECT_TRUE(stage.starts_with("#usda 1.0\n"));
  EXPECT_TRUE(contains(stage, "def Camera", "def SphereLight", "def Mesh \"floor\"", "def Volume",
                       "def OpenVDBAsset \"density\"", "@a_fog.vdb@",
                       "brume:homogeneousDensity = 0.02"));
  EXPECT_EQ(volume_grids(file("a_fog.vdb")).size(), 1u);
}

TEST_F(UsdExport, WritesAVolumeForEachFrame) {
  const std::string moving = folder_.write_scene(
      "m.brume", R"("camera": { "eye": [0, 0, 5], "target": [0, 0, 0], "keys": { "eye": [
      { "time": 0, "value": [0, 0, 5] }, { "time": 1, "value": [0, 0, 9] } ] } },
    "film": { "width": 24, "height": 18 },
    "medium": { "emitters": [ { "position": [0, 0, 0], "rate": 20 } ] },
    "lights": [])");
  expect_done(
      {"export", moving, "-o", file("m.usda"), "--frames", "5-6", "--fps", "10", "--voxel", "0.1"});
  const std::string stage = text_of("m.usda");
  EXPECT_TRUE(contains(stage, "5: @m_fog_0005.vdb@", "6: @m_fog_0006.vdb@",
                       "xformOp:transform.timeSamples", "timeCodesPerSecond = 10"));
  EXPECT_TRUE(std::filesystem::exists(file("m_fog_0006.vdb")));
  expect_done(
      {"export", moving, "-o", file("o.usda"), "--frames", "6", "--fps", "10", "--voxel", "0.1"});
  EXPECT_TRUE(contains(text_of("o.usda"), "6: @o_fog_0006.vdb@", "startTimeCode = 6"));
}

// 100 kB are all that a file may grow to: the volume fits, the stage does not.
TEST_F(UsdExport, ReplacesNeitherFileWhereTheStageDoesNotFit) {
  std::string obj;
  for (int i = 0; i < 3000; ++i) {
    obj += "v " + std::to_string(i) + " 0.123456 0\nv " + std::to_string(i) + " 1.654321 0\n";
  }
  for (int i = 1; i < 5999; ++i) {
    obj +=
        "f " + std::to_string(i) + ' ' + std::to_string(i + 1) + ' ' + std::to_string(i + 2) + '\n';
  }
  folder_.write("floor.obj", obj);
  folder_.write("o.usda", "old");
  folder_.write("o_fog.vdb", "old");
  const std::size_t entries = folder_.entry_count();
  const ProgramResult result = run_brume({"export", scene_, "-o", file("o.usda"), "--voxel", "0.5"},
                                         {.before = "ulimit -f 200; "});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(contains(result.err, file("o.usda") + ": cannot be written: File too large"));
  EXPECT_EQ(text_of("o.usda"), "old");
  EXPECT_EQ(text_of("o_fog.vdb"), "old");
  EXPECT_EQ(folder_.entry_count(), entries);
}

TEST_F(UsdExport, NeedsAScene) {
  folder_.write("g.csv", "x,y,z,radius,density\n0,0,0,1,1\n");
  expect_refused({"export", file("g.csv"), "-o", file("g.usda")}, {"g.csv", ".brume"});
  EXPECT_FALSE(std::filesystem::exists(file("g.usda")));
}

}  // namespace
}  // namespace brume
