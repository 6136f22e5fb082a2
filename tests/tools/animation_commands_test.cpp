// Scenes that move, on the command line.

#include <nlohmann/json.hpp>

#include "core/io/gaussians/gaussian_file.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

using AnimationCommands = CommandLine;
using Json = nlohmann::json;

TEST_F(AnimationCommands, RendersTheMomentOfItsKeys) {
  Json moving = Json::parse(scene_text);
  const auto keys = [](const Json& from, const Json& to) {
    return Json::array({{{"time", 1}, {"value", from}}, {{"time", 3}, {"value", to}}});
  };
  moving["camera"]["keys"] = {{"eye", keys({0, 0, 5}, {4, 0, 5})}};
  moving["medium"]["keys"] = {{"density", keys(0.0, 0.2)}};
  moving["lights"][0]["keys"] = {{"position", keys({2, 2, 2}, {-2, 2, 2})},
                                 {"intensity", keys({0, 0, 60}, {60, 0, 0})}};
  Json still = Json::parse(scene_text);
  still["camera"]["eye"] = {2, 0, 5};
  still["medium"]["density"] = 0.1;
  still["lights"][0]["position"] = {0, 2, 2};
  still["lights"][0]["intensity"] = {30, 0, 30};
  const std::string moving_scene = folder_.write("moving.brume", moving.dump());
  const std::string still_scene = folder_.write("still.brume", still.dump());
  const auto render = [&](const std::string& scene, const char* time, const char* image) {
    expect_done({"render", scene, "--airlight", "sliced", "--scattering", "single", "--time", time,
                 "-o", file(image)});
  };
  render(moving_scene, "2", "moving.exr");
  render(still_scene, "0", "still.exr");
  render(moving_scene, "1", "earlier.exr");
  expect_done({"compare", file("moving.exr"), file("still.exr"), "--max-rel-rmse", "0"});
  EXPECT_EQ(run_brume({"compare", file("earlier.exr"), file("still.exr"), "--max-rel-rmse", "0.1"})
                .exit_code,
            1);
}

// A scene plays the sequence that fit writes, and gather takes it along.
TEST_F(AnimationCommands, PlaysASequenceThatWasFitted) {
  const std::string volumes = BRUME_VOLUMES "/smoke_%04d.vdb";
  expect_done({"fit", volumes, "--frames", "25-26", "--up", "z", "--count", "12", "-o",
               file("s_%02d.csv")});
  const std::string scene = folder_.write_scene(
      "s.brume", R"("medium": { "sequences": [ { "file": "s_%02d.csv", "first": 25, "last": 26,
                                 "frames_per_second": 10 } ] })");
  const auto medium_at = [&](const char* time) {
    expect_done({"export", scene, "--time", time, "-o", file("m.ply")});
    return read_gaussians(file("m.ply"));
  };
  std::vector<GaussianNumber> ids;
  EXPECT_EQ(medium_at("0"), read_gaussians(file("s_25.csv"), &ids));
  ASSERT_EQ(ids.size(), 12u);
  EXPECT_EQ(medium_at("0.1").size(), 12u);
  EXPECT_GE(medium_at("0.05").size(), 12u);

  expect_done({"gather", scene, file("out")});
  std::filesystem::remove(file("s_25.csv"));
  expect_done({"export", file("out/s.brume"), "-o", file("n.ply")});
  EXPECT_EQ(read_gaussians(file("n.ply")).size(), 12u);
  expect_refused({"gather", file("out/s.brume"), file("out")}, {"out", "already exists"});
  expect_refused({"export", scene, "-o", file("n.ply")}, {"medium.sequences[0].file", "s_25.csv"});
}

// Eight in one place are one of eight times the density.
TEST_F(AnimationCommands, ExportSimplifies) {
  std::string rows = "x,y,z,radius,density\n";
  for (int i = 0; i < 8; ++i) rows += "0,0,0,0.5,0.1\n";
  folder_.write("crowd.csv", rows);
  const ProgramResult result =
      expect_done({"export", file("crowd.csv"), "-o", file("few.csv"), "--simplify", "0.01"});
  EXPECT_TRUE(contains(result.err, "8 Gaussians became 1, with an error of "));
  const std::vector<Gaussian> few = read_gaussians(folder_ / "few.csv");
  ASSERT_EQ(few.size(), 1u);
  EXPECT_NEAR(few[0].density, 0.8, 1e-12);
  EXPECT_NEAR(few[0].radius, 0.5, 1e-12);
  EXPECT_EQ(
      run_brume({"export", file("crowd.csv"), "-o", file("few.csv"), "--simplify", "0"}).exit_code,
      2);
}

TEST_F(AnimationCommands, ExportMakesTheOtherFramesOfASequence) {
  for (const char* name : {"g_1.csv", "g_3.csv"}) {
    folder_.write(name, "x,y,z,radius,density\n0,0,0,1,1\n");
  }
  folder_.write("g_2.csv", "x,y,z,radius,density\n0,0,0,-1,1\n");
  const ProgramResult result =
      run_brume({"export", file("g_%d.csv"), "-o", file("h_%d.ply"), "--frames", "1-3"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(contains(result.err, "error: frame 2: "));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "h_1.ply"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "h_2.ply"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "h_3.ply"));
}

}  // namespace
}  // namespace brume
