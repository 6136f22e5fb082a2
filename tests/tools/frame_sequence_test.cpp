// Frames of an animation, one file each, from one process or several.

#include <csignal>
#include <nlohmann/json.hpp>

#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"
#include "tests/tools/running_program.h"

namespace brume {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class FrameSequence : public CommandLine {
 protected:
  FrameSequence() {
    Json scene = Json::parse(scene_text);
    const auto keys = [](const Json& from, const Json& to) {
      return Json::array({{{"time", 0}, {"value", from}}, {{"time", 1}, {"value", to}}});
    };
    scene["camera"]["keys"] = {{"eye", keys({0, 0, 5}, {4, 0, 5})}};
    scene["lights"][0]["keys"] = {{"intensity", keys({0, 0, 60}, {60, 0, 0})}};
    moving_ = folder_.write("moving.brume", scene.dump());
  }

  // The report of the program.
  Json render(std::vector<std::string> more, int exit_code = 0) {
    const ProgramResult result =
        run_brume(joined({"render", moving_, "--airlight", "sliced", "--scattering", "single",
                          "--backend", "cpu", "--fps", "10"},
                         more));
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    errors_ = result.err;
    return result.out.empty() ? Json() : Json::parse(result.out);
  }

  std::string bytes(const char* name) { return read_bytes(folder_ / name); }

  std::string moving_;
  std::string errors_;
};

TEST_F(FrameSequence, FramesAreThoseThatAreRenderedAlone) {
  const Json result = render({"--frames", "0-4x2,3,2", "-o", file("s_%04d.exr")});
  EXPECT_EQ(result["made"], Json({0, 2, 4, 3}));
  EXPECT_EQ(result["skipped"], Json::array());
  EXPECT_EQ(result["failed"], Json::array());
  EXPECT_FALSE(fs::exists(folder_ / "s_0001.exr"));
  for (const int frame : {0, 2, 3, 4}) {
    render({"--time", std::to_string(0.1 * frame), "-o", file("alone.exr")});
    const std::string name = "s_000" + std::to_string(frame) + ".exr";
    EXPECT_EQ(read_exr(folder_ / name).channels, read_exr(folder_ / "alone.exr").channels) << name;
  }
  EXPECT_NE(read_exr(folder_ / "s_0000.exr").channels, read_exr(folder_ / "s_0004.exr").channels);
}

TEST_F(FrameSequence, FilesAreTheSameInAnyOrderChunksAndThreads) {
  render({"--frames", "0-5", "-o", file("a_%d.exr")});
  render({"--frames", "5,3,4", "--threads", "1", "-o", file("b_%d.exr")});
  render({"--frames", "0-2", "-o", file("b_%d.exr")});
  for (int frame = 0; frame <= 5; ++frame) {
    const std::string number = std::to_string(frame) + ".exr";
    EXPECT_EQ(bytes(("a_" + number).c_str()), bytes(("b_" + number).c_str())) << frame;
  }
}

TEST_F(FrameSequence, SkipsFramesThatAreWholeAndCurrent) {
  for (const std::string extension : {".exr", ".png", ".deep.exr"}) {
    const std::string images = file(("s_%04d" + extension).c_str());
    const auto made = [&](const std::vector<std::string>& more = {}) {
      return render(joined({"--frames", "0-3", "--skip-existing", "--size", "8", "-o", images},
                           more))["made"];
    };
    const Json all{0, 1, 2, 3};
    EXPECT_EQ(made(), all);
    EXPECT_EQ(made(), Json::array());
    EXPECT_EQ(made({"--threads", "1"}), Json::array());
    // Cut short, foreign, or gone.
    const fs::path second = folder_ / ("s_0001" + extension);
    fs::resize_file(second, fs::file_size(second) - 100);
    folder_.write("s_0002" + extension, "no image");
    fs::remove(folder_ / ("s_0003" + extension));
    EXPECT_EQ(made(), Json({1, 2, 3})) << extension;
    // The file is that of another frame.
    fs::copy_file(folder_ / ("s_0000" + extension), second, fs::copy_options::overwrite_existing);
    EXPECT_EQ(made(), Json({1}));
    if (extension != ".exr") continue;
    // Made from something else.
    EXPECT_EQ(made({"--slices", "16"}), all);
    EXPECT_EQ(made({"--slices", "16"}), Json::array());
    EXPECT_EQ(made(), all);
    folder_.write("floor.obj", "v -2 -1 -2\nv -2 -1 2\nv 2 -1 2\nf 1 2 3\n");
    EXPECT_EQ(made(), all);
    folder_.write("floor.obj", "v -2 -1 -2\nv -2 -1 2\nv 2 -1 2\nv 2 -1 -2\nf 1 2 3 4\n");
    EXPECT_EQ(made(), all);
  }
}

TEST_F(FrameSequence, LooksAreTheContentOfTheirFiles) {
  const auto lut = [&](const char* white) {
    folder_.write(
        "luts/curve.spi1d",
        std::string("Version 1\nFrom 0.0 1.0\nLength 2\nComponents 1\n{\n0.0\n") + white + "\n}\n");
  };
  const auto config = [&](const std::string& more) {
    folder_.write("look.ocio", R"(ocio_profile_version: 1
search_path: "luts"
roles:
  scene_linear: linear
displays:
  screen:
    - !<View> {name: curved, colorspace: curved}
colorspaces:
  - !<ColorSpace>
    name: linear
  - !<ColorSpace>
    name: curved
    from_reference: !<FileTransform> {src: curve.spi1d, interpolation: linear}
)" + more);
  };
  const auto made = [&](const std::vector<std::string>& look) {
    return render(joined(words("--frames 1 --skip-existing --size 8 -o"),
                         joined({file("s_%d.png")}, look)))["made"];
  };
  const Json one{1};
  const Json none = Json::array();
  const std::vector<std::string> look{"--color-config", file("look.ocio")};
  lut("0.5");
  config("");
  EXPECT_EQ(made(look), one);
  EXPECT_EQ(made(look), none);
  lut("0.7");
  EXPECT_EQ(made(look), one);
  config("  - !<ColorSpace>\n    name: another\n");
  EXPECT_EQ(made(look), one);
  EXPECT_EQ(made(look), none);
  // The same by another way.
  ::setenv("OCIO", file("look.ocio").c_str(), 1);
  EXPECT_EQ(made({"--view", "curved"}), none);
  lut("0.8");
  EXPECT_EQ(made({"--view", "curved"}), one);
  ::unsetenv("OCIO");
  EXPECT_EQ(made({"--color-config", "aces"}), one);
  EXPECT_EQ(made({}), one);
  EXPECT_EQ(made({}), none);
}

// One file is missing and one frame cannot be written: the others are made.
TEST_F(FrameSequence, AFrameThatFailsLeavesTheOthersAlone) {
  for (int frame = 0; frame < 6; ++frame) {
    const std::vector<Gaussian> gaussians{{{0.1 * frame, 0, 0}, 1.0, 0.5}};
    write_gaussians(folder_ / ("fog_" + std::to_string(frame) + ".ply"), gaussians);
  }
  fs::remove(folder_ / "fog_3.ply");
  Json scene = Json::parse(scene_text);
  scene["medium"]["sequences"] =
      Json::array({{{"file", "fog_%d.ply"}, {"first", 0}, {"last", 5}, {"frames_per_second", 10}}});
  moving_ = folder_.write("played.brume", scene.dump());
  fs::create_directory(folder_ / "s_5.exr.folder");
  const Json result = render({"--frames", "0-5", "-o", file("s_%d.exr")}, 1);
  EXPECT_EQ(result["made"], Json({0, 1, 2, 4, 5}));
  EXPECT_EQ(result["failed"], Json({3}));
  EXPECT_EQ(errors_, "brume: error: frame 3: " + file("fog_3.ply") + ": is missing\n");
  // Any other file that is missing ends it all.
  fs::remove(folder_ / "floor.obj");
  render({"--frames", "0-5", "-o", file("s_%d.exr")}, 2);
  EXPECT_TRUE(contains(errors_, "surfaces[0].mesh"));
}

TEST_F(FrameSequence, RefusesWhatCannotBeMeant) {
  const auto refused = [this](std::vector<std::string> more, const std::string& part) {
    expect_refused(joined({"render", moving_}, more), {part});
  };
  for (const char* range : {"", "4-2", "1-", "-3", "1-9x0", "1-9x", "1,,2", "a", "1-2000000000"}) {
    if (*range != '\0') refused({"--frames", range, "-o", file("s_%d.png")}, "--frames: found");
  }
  refused({"--frames", "1-2", "-o", file("s.png")}, "%04d for the frame");
  refused({"-o", file("s_%d.png")}, "a sequence needs --frames");
  refused({"--skip-existing", "-o", file("s.png")}, "--skip-existing: is of a sequence");
  refused({"--frames", "1", "--repeat", "2", "-o", file("s_%d.png")}, "--repeat");
  refused({"--frames", "1", "--time", "1", "-o", file("s_%d.png")}, "--time");
  refused({"--frames", "1", "-o", file("floor.obj/s_%d.png")}, "floor.obj");
}

// Ended in the middle, what is there is whole, and going on makes the rest.
TEST_F(FrameSequence, CanBeEndedAndGoOn) {
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const std::vector<std::string> arguments =
        joined({"render", moving_, "-o", file("k_%d.exr"), "--frames", "0-9", "--skip-existing"},
               words("--airlight sliced --backend cpu --scattering single --size 200x150"));
    {
      RunningProgram program(arguments);
      ASSERT_TRUE(program.wait_for("3 of 10")) << program.shown();
      ::kill(program.pid(), signal);
      program.wait();
    }
    std::size_t whole = 0;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      if (!entry.path().filename().string().starts_with("k_")) continue;
      EXPECT_NO_THROW(read_exr(entry.path())) << entry.path();
      ++whole;
    }
    EXPECT_GE(whole, 1u);
    EXPECT_LT(whole, 10u);
    const ProgramResult rest = expect_done(arguments);
    EXPECT_GE(Json::parse(rest.out)["skipped"].size(), whole);
    for (int frame = 0; frame <= 9; ++frame) {
      fs::remove(folder_ / ("k_" + std::to_string(frame) + ".exr"));
    }
    // The scenes and the floor: nothing is left of what was being written.
    EXPECT_EQ(folder_.entry_count(), 3u);
  }
}

}  // namespace
}  // namespace brume
