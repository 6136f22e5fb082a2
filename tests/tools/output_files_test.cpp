#include <gtest/gtest.h>

#include <filesystem>

#include "core/io/gaussians/gaussian_file.h"
#include "core/io/volume/volume_file.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

// Scenes and files large enough not to fit into what a limit lets through.
class OutputFiles : public CommandLine {
 protected:
  OutputFiles() {
    std::vector<Gaussian> gaussians;
    for (int i = 0; i < 100; ++i) gaussians.push_back({{i / 7.0, i / 9.0, i / 11.0}, 2.0, 0.5});
    write_gaussians(folder_ / "many.ply", gaussians);
    ImageLayers sky;
    sky.width = 4;
    sky.height = 2;
    for (const char* channel : {"R", "G", "B"}) sky.channels[channel] = std::vector<float>(8, 1.0f);
    write_exr(folder_ / "sky.exr", sky);
    many_ = folder_.write_scene(
        "many.brume", R"("medium": { "file": "many.ply" }, "film": { "width": 24, "height": 18 },
  "environment": { "file": "sky.exr" }, "surfaces": [ { "mesh": "floor.obj" } ])");
  }

  // Refused, and all files are what they were.
  void expect_cached(const std::vector<std::string>& arguments,
                     const std::vector<std::string>& parts) const {
    SCOPED_TRACE(arguments.back());
    const auto before = contents();
    expect_refused(arguments, parts);
    EXPECT_EQ(contents(), before);
  }

  [[nodiscard]] std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      all[entry.path().string()] = entry.is_regular_file() ? content_of(entry.path()) : "";
    }
    return all;
  }

  std::string many_;
};

struct FullDiskCase {
  const char* output;
  std::vector<std::string> arguments;
};

// 1024 bytes are all that a file may grow to.
TEST_F(OutputFiles, AFullDiskPreservesTheOldFile) {
  expect_done({"export", many_, "-o", file("in.vdb"), "--voxel", "1"});
  const std::vector<FullDiskCase> cases{
      {"o.exr", {"render", many_, "-o", file("o.exr"), "--airlight", "paper"}},
      {"o.png", {"render", many_, "-o", file("o.png"), "--airlight", "paper", "--size", "99x99"}},
      {"s.json",
       {"render", scene_, "-o", file("tiny.png"), "--airlight", "paper", "--size", "1x1", "--stats",
        file("s.json")}},
      {"o.vdb", {"export", many_, "-o", file("o.vdb"), "--voxel", "1"}},
      {"h.vdb", {"export", many_, "-o", file("h.vdb"), "--voxel", "1", "--half"}},
      {"o.ply", {"export", many_, "-o", file("o.ply")}},
      {"o.csv", {"export", many_, "-o", file("o.csv")}},
      {"f.ply", {"fit", file("in.vdb"), "-o", file("f.ply"), "--count", "30"}},
      {"f.csv", {"fit", file("in.vdb"), "-o", file("f.csv"), "--count", "30"}},
      {"report.json", {"bench", "--quick", scene_, "-o", file("report")}},
      {"cloud_30_depth_1.brume", {"bench", "--save-scenes", folder_.path().string()}},
  };
  for (const FullDiskCase& c : cases) {
    SCOPED_TRACE(c.output);
    folder_.write(c.output, "old");
    const ProgramResult result = run_brume(c.arguments, {.before = "ulimit -f 2; "});
    EXPECT_EQ(result.exit_code, 2);
    const std::size_t begin = result.err.find("brume: error: ");
    ASSERT_NE(begin, std::string::npos) << result.err;
    EXPECT_EQ(result.err.substr(begin),
              "brume: error: " + file(c.output) + ": cannot be written: File too large\n");
    EXPECT_EQ(content_of(folder_ / c.output), "old");
    for (const auto& [name, content] : contents()) {
      EXPECT_FALSE(name.ends_with(".tmp")) << name;
    }
  }
}

TEST_F(OutputFiles, AFullDiskLeavesNoGatheredScene) {
  const std::size_t entries = folder_.entry_count();
  const ProgramResult result =
      run_brume({"gather", many_, file("all")}, {.before = "ulimit -f 2; "});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(result.err.starts_with("brume: error: " + file("all") + ": cannot be created: "));
  EXPECT_TRUE(contains(result.err, "many.ply: cannot be written: File too large"));
  EXPECT_EQ(folder_.entry_count(), entries);
}

TEST_F(OutputFiles, StandardOutputIsChecked) {
  write_image("a.exr", {{"R", 1.0f}, {"G", 1.0f}, {"B", 1.0f}});
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--help"},
                                             {"--version"},
                                             {"render", "-h"},
                                             {"info", scene_},
                                             {"info", "--json", scene_},
                                             {"compare", file("a.exr"), file("a.exr")},
                                             {"bench", "--save-scenes", folder_.path().string()}}) {
    SCOPED_TRACE(arguments.front());
    const ProgramResult result = run_brume(arguments, {.out = "/dev/full"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err,
              "brume: error: standard output: cannot be written: No space left on device\n");
  }
}

TEST_F(OutputFiles, NoOutputIsAnInput) {
  fs::create_symlink("sky.exr", folder_ / "link.exr");
  fs::create_hard_link(folder_ / "sky.exr", folder_ / "hard.exr");
  fs::create_symlink("many.ply", folder_ / "link.csv");
  const std::string same = "is the same file as the input ";
  expect_cached({"render", scene_, "-o", file("o.png"), "--stats", scene_}, {scene_ + ": " + same});
  expect_cached({"render", many_, "-o", file("o.png"), "--stats", file("floor.obj")},
                {"floor.obj: " + same});
  for (const char* name : {"sky.exr", "./sky.exr", "link.exr", "hard.exr"}) {
    expect_cached({"render", many_, "-o", file(name)}, {file(name) + ": " + same, "sky.exr"});
  }
  for (const char* name : {"many.ply", "link.csv"}) {
    expect_cached({"export", many_, "-o", file(name)}, {file(name) + ": " + same, "many.ply"});
  }
  expect_cached({"export", file("many.ply"), "-o", file("./many.ply")}, {same});

  fs::copy_file(std::string(BRUME_VOLUMES) + "/smoke_0025.vdb", folder_ / "smoke.vdb");
  fs::create_symlink("smoke.vdb", folder_ / "volume.ply");
  expect_cached({"fit", file("smoke.vdb"), "-o", file("volume.ply")}, {"volume.ply: " + same});

  folder_.write("report.json", R"({ "scenes": [], "table_one": [] })");
  folder_.write("peers.json", R"({ "peers": [] })");
  expect_cached({"bench", "-o", file("report"), "--compare", file("report.json")},
                {"report.json: " + same});
  expect_cached({"bench", "-o", file("peers"), "--peers", file("peers.json")},
                {"peers.json: " + same});
  fs::create_symlink("a.brume", folder_ / "a.svg");
  expect_cached({"bench", scene_, "-o", file("a")}, {"a.svg: " + same});
}

TEST_F(OutputFiles, NoFrameOfASequenceIsAnInput) {
  fs::copy_file(folder_ / "many.ply", folder_ / "m_1.ply");
  fs::copy_file(folder_ / "many.ply", folder_ / "m_2.ply");
  const std::string same = "is the same file as the input ";
  expect_cached({"export", file("m_%d.ply"), "--frames", "1-2", "-o", file("m_%d.ply")}, {same});
  // Already before the first frame is written.
  fs::create_symlink("m_2.ply", folder_ / "o_2.csv");
  expect_cached({"export", file("m_%d.ply"), "--frames", "1-2", "-o", file("o_%d.csv")},
                {"o_2.csv: " + same});
}

TEST_F(OutputFiles, NoTwoOutputsAreOneFile) {
  const std::string same = "is the same file as the output ";
  expect_cached({"render", scene_, "-o", file("o.exr"), "--stats", file("o.exr")}, {same});
  expect_cached({"render", scene_, "-o", file("o.exr"), "--stats", file("./o.exr")}, {same});
  fs::create_symlink("o.exr", folder_ / "s.json");
  expect_cached({"render", scene_, "-o", file("o.exr"), "--stats", file("s.json")}, {same});
  fs::create_symlink("s.json", folder_ / "t.json");
  expect_cached({"render", scene_, "-o", file("o.exr"), "--stats", file("t.json")}, {same});
  folder_.write("o.exr", "old");
  expect_cached({"render", scene_, "-o", file("o.exr"), "--stats", file("t.json")}, {same});
}

TEST_F(OutputFiles, RefusesToGatherIntoTheScenesFolder) {
  expect_cached({"gather", scene_, folder_.path().string()}, {"already exists"});
}

}  // namespace
}  // namespace brume
