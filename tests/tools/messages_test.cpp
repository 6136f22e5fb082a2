#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/printable_text.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

using Messages = CommandLine;

// Escape sequences of C0 and C1, and an override of the direction.
constexpr const char* hostile =
    "\x1b]0;title\x07\xc2\x9b"
    "31m\xe2\x80\xaegpj\x7f";
constexpr const char* harmless = "\\u001b]0;title\\u0007\\u009b31m\\u202egpj\\u007f";

void expect_printable(const ProgramResult& result) {
  EXPECT_EQ(printable_lines(result.out), result.out);
  EXPECT_EQ(printable_lines(result.err), result.err);
}

TEST_F(Messages, DoNotDriveTheTerminal) {
  const std::string key = hostile;
  const std::string scene =
      folder_.write(key + ".brume", nlohmann::json{{"format", "brume-scene"},
                                                   {"version", 1},
                                                   {key, 1},
                                                   {"film", {{"width", 2}, {"height", 2}}}}
                                        .dump());
  const ProgramResult info = expect_done({"info", scene});
  expect_printable(info);
  EXPECT_TRUE(contains(info.out, harmless));
  EXPECT_TRUE(contains(info.err, std::string(harmless) + ": unknown key"));

  const ProgramResult as_json = run_brume({"info", "--json", scene});
  expect_printable(as_json);
  EXPECT_EQ(nlohmann::json::parse(as_json.out)["file"], scene);

  const std::string bad = folder_.write("bad.brume", nlohmann::json{{"format", key}}.dump());
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"info", bad},
           {"info", scene + key},
           {key},
           {"--" + key},
           {"render", scene, "-o", file("o.png"), "--size", key},
           {"render", scene, "-o", file("o.png"), "--backend", key},
           {"render", scene, "-o", file("o.png"), "--threads", key},
           {"render", scene, "-o",
            std::filesystem::path(scene) / key / "o.png"},  // a file is no folder
           {"export", scene, "-o", file("o.vdb"), "--frames", key}}) {
    SCOPED_TRACE(arguments.front());
    const ProgramResult result = run_brume(arguments);
    EXPECT_EQ(result.exit_code, 2);
    expect_printable(result);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

TEST_F(Messages, ManyWarningsAreCounted) {
  nlohmann::json scene{{"format", "brume-scene"}, {"version", 1}};
  for (int i = 0; i < 500; ++i) scene["medium"]["unknown_" + std::to_string(i)] = i;
  for (int i = 0; i < 500; ++i) scene["unknown_" + std::to_string(i)] = i;
  const ProgramResult result = expect_done({"info", folder_.write("w.brume", scene.dump())});
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 21) << result.err;
  EXPECT_TRUE(
      contains(result.err, "unknown_0: unknown key", "w.brume: and 980 more warnings like these"));
}

TEST_F(Messages, NameWhatIsGatheredFromElsewhere) {
  std::string surfaces = R"({ "mesh": "../floor.obj" })";
  const std::string floor = content_of(folder_ / "floor.obj");
  for (int i = 10; i < 22; ++i) {
    const std::string name = "elsewhere/" + std::to_string(i) + ".obj";
    folder_.write(name, floor);
    surfaces += R"(, { "mesh": "../)" + name + "\" }";
  }
  folder_.write("here/own.obj", floor);
  const auto scene = [&](const char* name, const std::string& list) {
    const std::string text = R"({ "format": "brume-scene", "version": 1, "surfaces": [ )";
    return folder_.write(name, text + list + " ] }");
  };
  const ProgramResult own =
      expect_done({"gather", scene("here/a.brume", R"({ "mesh": "own.obj" })"), file("own")});
  EXPECT_FALSE(contains(own.err, "outside"));
  const ProgramResult others =
      expect_done({"gather", scene("here/b.brume", surfaces), file("all")});
  const std::string note = "copied from outside the scene's folder: " + file("floor.obj") + ", " +
                           file("elsewhere/10.obj");
  EXPECT_TRUE(contains(others.err, note, "18.obj and 3 more\n"));
}

TEST_F(Messages, SuggestASufficientVoxelSize) {
  const std::string scene = folder_.write_scene("small.brume", R"("medium": { "gaussians": [
  { "center": [0, 0, 0], "radius": 1, "density": 1 },
  { "center": [1, 0, 0], "radius": 1e-12, "density": 1 } ] })");
  const ProgramResult refused = run_brume({"export", scene, "-o", file("o.vdb")});
  EXPECT_EQ(refused.exit_code, 2);
  const std::string before =
      "voxels of 5e-13 needs more than 2148 MB; allowed: a larger --voxel, of ";
  const std::size_t at = refused.err.find(before);
  ASSERT_NE(at, std::string::npos) << refused.err;
  const std::string rest = refused.err.substr(at + before.size());
  ASSERT_TRUE(contains(rest, " or more\n"));
  const std::string size = rest.substr(0, rest.find(' '));
  EXPECT_LE(size.size(), 7u) << "two digits";
  // The size named is enough, and not much more than it must be; grids of gigabytes are not
  // made here.
  const double voxel = std::stod(size);
  EXPECT_GT(voxel, 0.002);
  EXPECT_LT(voxel, 0.02);
  expect_done({"export", scene, "-o", file("o.vdb"), "--voxel", "0.1"});
}

}  // namespace
}  // namespace brume
