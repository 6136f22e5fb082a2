// Folders of outputs: with a percent in their name, and those that are not there yet.

#include <sys/stat.h>

#include "core/io/gaussians/gaussian_file.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

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
