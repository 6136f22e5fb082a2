#include <gtest/gtest.h>

#include <sys/stat.h>
#include <filesystem>

#include "core/io/gaussians/gaussian_file.h"
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

// Folders of outputs: with a percent in their name, and those that are not there yet.

namespace fs = std::filesystem;

class OutputFolders : public CommandLine {
 protected:
  void expect_file(const char* name) const {
    EXPECT_TRUE(fs::is_regular_file(folder_ / name)) << name;
  }

  const std::vector<std::string> quick_{"render", scene_, "--airlight", "paper", "--size", "4x3"};
  std::vector<std::string> render(std::vector<std::string> more) const {
    return joined(quick_, more);
  }
};

TEST_F(OutputFolders, MayHavePercentsInTheirNames) {
  expect_done(render({"-o", file("50%density/a.png")}));
  expect_file("50%density/a.png");
  expect_done(render({"--frames", "1-2", "-o", file("50%density/a_%04d.png")}));
  expect_file("50%density/a_0002.png");
  expect_done(render({"--frames", "1", "-o", file("%d/%%d/100%%_%%d_%02d.png")}));
  expect_file("%d/%%d/100%_%d_01.png");
  expect_done({"export", scene_, "--frames", "0", "-o", file("%d/s_%d.ply")});
  expect_file("%d/s_0.ply");
  expect_done({"export", file("%d/s_%d.ply"), "--frames", "0", "-o", file("%d/%%%d.csv")});
  expect_file("%d/%0.csv");
  fs::copy_file(std::string(BRUME_VOLUMES) + "/smoke_0025.vdb", folder_ / "%d/v_25.vdb");
  expect_done(
      {"fit", file("%d/v_%d.vdb"), "--frames", "25", "--count", "4", "-o", file("1%d/v_%d.ply")});
  expect_file("1%d/v_25.ply");
}

TEST_F(OutputFolders, OfAScenesSequenceMayHaveThem) {
  write_gaussians(fs::path(folder_.write("5%d/x", "").parent_path()) / "s_7.ply",
                  std::vector<Gaussian>{{{0, 0, 0}, 1.0, 0.5}});
  const std::string scene = folder_.write_scene(
      "s.brume",
      R"("medium": { "sequences": [ { "file": "5%d/s_%d.ply", "first": 7, "last": 7 } ] })");
  expect_done({"gather", scene, file("new/all")});
  expect_file("new/all/s.brume");
  expect_done({"info", file("new/all/s.brume")});
}

TEST_F(OutputFolders, AreMade) {
  expect_done(render({"-o", file("a/b/o.exr"), "--stats", file("c/s.json")}));
  expect_file("a/b/o.exr");
  expect_file("c/s.json");
  expect_done({"render", scene_, "--airlight", "sliced", "--scattering", "single", "--size", "4x3",
               "-o", file("d/o.deep.exr")});
  expect_file("d/o.deep.exr");
  expect_done({"export", scene_, "-o", file("e/f/m.usda"), "--voxel", "0.5"});
  expect_file("e/f/m_fog.vdb");
  fs::copy_file(std::string(BRUME_VOLUMES) + "/smoke_0025.vdb", folder_ / "v.vdb");
  expect_done({"fit", file("v.vdb"), "--count", "4", "-o", file("g/v.ply")});
  expect_file("g/v.ply");
  expect_done({"submit", "openjd", scene_, "--frames", "0", "-o", file("h/i/f_%d.exr")});
  expect_file("h/i/f.openjd/template.json");
  expect_done({"gather", scene_, file("j/k/")});
  expect_file("j/k/a.brume");
  fs::create_symlink("l/o.exr", folder_ / "link.exr");
  expect_done(render({"-o", file("link.exr")}));
  expect_file("l/o.exr");
  const std::string at_home = "cd " + quoted(folder_.path().string()) + "; ";
  for (const char* image : {"m.exr", "n/./m.exr", "n/../o/m.exr"}) {
    EXPECT_EQ(run_brume(render({"-o", image}), {.before = at_home}).exit_code, 0) << image;
    expect_file(image);
  }
}

TEST_F(OutputFolders, AreLeftOutWhereNothingIsWritten) {
  const std::size_t entries = folder_.entry_count();
  expect_refused({"render", file("none.brume"), "-o", file("a/b/o.exr")}, {"none.brume"});
  expect_refused({"submit", "openjd", scene_, "--frames", "0", "-o", file("a/{{_%d.exr")}, {"{{"});
  expect_refused({"render", scene_, "-o", file("floor.obj/a/o.exr")}, {"cannot be created"});
  EXPECT_EQ(folder_.entry_count(), entries);
}

// Opening the pipe would wait for its other end.
TEST_F(OutputFolders, PipesAreNotOpened) {
  const auto make_pipe = [this](const char* name) {
    ASSERT_EQ(::mkfifo((folder_ / name).c_str(), 0600), 0);
  };
  make_pipe(".brume-1.tmp");
  expect_done(render({"--frames", "0", "-o", file("f_%d.exr")}));
  EXPECT_TRUE(fs::is_fifo(folder_ / ".brume-1.tmp"));
  make_pipe("p.brume");
  expect_refused({"render", file("p.brume"), "-o", file("o.exr")}, {"not a regular file"});
  make_pipe("f_1.exr");
  expect_refused(render({"--frames", "0-1", "--skip-existing", "-o", file("f_%d.exr")}),
                 {"f_1.exr", "not a regular file"});
  make_pipe("lut.spi1d");
  folder_.write("c.ocio", R"(ocio_profile_version: 1
search_path: .
roles: {scene_linear: linear}
displays:
  screen:
    - !<View> {name: curve, colorspace: curved}
colorspaces:
  - !<ColorSpace>
    name: linear
  - !<ColorSpace>
    name: curved
    from_reference: !<GroupTransform>
      children:
        - !<FileTransform> {src: lut.spi1d, interpolation: linear}
)");
  expect_refused(render({"-o", file("o.png"), "--color-config", file("c.ocio")}),
                 {"lut.spi1d", "not a regular file"});
}

}  // namespace

}  // namespace brume
