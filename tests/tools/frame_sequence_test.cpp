// Frames of an animation, one file each, from one process or several.

#include <gtest/gtest.h>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "core/fit/volume_fitter.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"
#include "tests/tools/running_program.h"
#include "tools/bench/measure/frames.h"

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
      return render(joined({"--frames", "0-4", "--skip-existing", "--size", "8", "-o", images},
                           more))["made"];
    };
    const auto image = [&](const char* frame) { return folder_ / (frame + extension); };
    const Json all{0, 1, 2, 3, 4};
    EXPECT_EQ(made(), all);
    EXPECT_EQ(made({"--threads", "1"}), Json::array());
    // Cut short, foreign, gone, or that of another frame.
    fs::resize_file(image("s_0001"), fs::file_size(image("s_0001")) - 100);
    folder_.write("s_0002" + extension, "no image");
    fs::remove(image("s_0003"));
    fs::copy_file(image("s_0000"), image("s_0004"), fs::copy_options::overwrite_existing);
    EXPECT_EQ(made(), Json({1, 2, 3, 4})) << extension;
    if (extension != ".exr") continue;
    // Made from something else.
    EXPECT_EQ(made({"--slices", "16"}), all);
    EXPECT_EQ(made(), all);
    folder_.write("floor.obj", "v -2 -1 -2\nv -2 -1 2\nv 2 -1 2\nf 1 2 3\n");
    EXPECT_EQ(made(), all);
    folder_.write("floor.obj", "v -2 -1 -2\nv -2 -1 2\nv 2 -1 2\nv 2 -1 -2\nf 1 2 3 4\n");
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
  for (const char* range : {"4-2", "1-", "-3", "1-9x0", "1-9x", "1,,2", "a", "1-2000000000"}) {
    refused({"--frames", range, "-o", file("s_%d.png")}, "--frames: found");
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
               words("--airlight sliced --backend cpu --scattering single --size 120x90"));
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

// --seed, --error, and --stats of a sequence.

using Json = nlohmann::json;

class RenderStatistics : public CommandLine {
 protected:
  // The statistics that --stats writes.
  Json render(std::vector<std::string> more) {
    expect_done(joined(
        {"render", scene_, "--backend", "cpu", "--size", "8x6", "--stats", file("s.json")}, more));
    return Json::parse(content_of(folder_ / "s.json"));
  }
  ImageLayers traced(const char* image, std::vector<std::string> more) {
    seed_ = render(joined({"--airlight", "path:16", "-o", file(image)}, more))["seed"];
    return read_exr(folder_ / image);
  }

  Json seed_;
};

TEST_F(RenderStatistics, SeedsAreIndependentPictures) {
  const std::vector<float> first = traced("0.exr", {}).channels.at("R");
  EXPECT_EQ(seed_, 0);
  EXPECT_EQ(traced("0.exr", {"--seed", "0"}).channels.at("R"), first);
  const std::vector<float> other = traced("1.exr", {"--seed", "4294967295"}).channels.at("R");
  EXPECT_EQ(seed_, 4294967295);
  std::size_t different = 0;
  double sum = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    different += static_cast<std::size_t>(first[i] != other[i]);
    sum += static_cast<double>(first[i]);
    difference += static_cast<double>(other[i] - first[i]);
  }
  EXPECT_GT(different, first.size() * 9 / 10);
  EXPECT_LT(std::abs(difference), 0.3 * sum);  // of 16 paths in 48 pixels
  expect_refused({"render", scene_, "-o", file("o.exr"), "--seed", "-1"}, {"--seed"});
}

TEST_F(RenderStatistics, NoErrorIsMeasuredWhereNoneIsWanted) {
  for (const char* method : {"auto", "sliced"}) {
    SCOPED_TRACE(method);
    const std::vector<std::string> options{"--airlight",  method,         "-o",
                                           file("o.exr"), "--scattering", "single"};
    const auto error = [&](const char* wanted) {
      return render(joined(options, {"--error", wanted}))["error"];
    };
    EXPECT_TRUE(error("none").is_null());
    EXPECT_FALSE(read_exr(folder_ / "o.exr").metadata.contains("brume:error"));
    const Json quick = error("quick");
    EXPECT_GT(quick["pixels"], 0);
    EXPECT_LE(quick["blocks"]["low"], quick["blocks"]["median"]);
    EXPECT_LE(quick["blocks"]["median"], quick["blocks"]["high"]);
    EXPECT_TRUE(read_exr(folder_ / "o.exr").metadata.contains("brume:error"));
    EXPECT_TRUE(read_exr(folder_ / "o.exr").metadata.contains("brume:block_error"));
    EXPECT_EQ(render(options)["error"], quick) << "it is the default";
    EXPECT_GE(error("full")["pixels"], quick["pixels"]);
  }
  expect_refused({"render", scene_, "-o", file("o.exr"), "--error", "some"},
                 {"--error", "allowed: none, quick, full"});
}

// Whatever part of it a process renders, a shot has one setting, and its frames no error.
TEST_F(RenderStatistics, AutoChoosesOnceForAShot) {
  const auto frames = [&](const char* which, const std::vector<std::string>& more) {
    return render(joined({"--frames", which, "--fps", "10", "-o", file("f_%d.exr"), "--scattering",
                          "single", "--max-error", "0.01"},
                         more))["frames"];
  };
  const Json all = frames("0-3", {});
  ASSERT_EQ(all.size(), 4u);
  for (const Json& frame : all) {
    EXPECT_EQ(frame["airlight"], "sliced");
    EXPECT_EQ(frame["slices"], all[0]["slices"]);
    EXPECT_EQ(frame["airlight_scale"], 4);
    EXPECT_TRUE(frame["error"].is_null());
  }
  EXPECT_EQ(frames("3", {})[0]["slices"], all[3]["slices"]);
  EXPECT_GT(frames("3", {"--error", "quick"})[0]["error"]["pixels"], 0);
}

TEST_F(RenderStatistics, OfASequenceListItsFrames) {
  const std::vector<std::string> options = joined(
      words("--airlight sliced --scattering single --frames 3,0 --fps 10 -o"), {file("f_%d.exr")});
  const Json frames = render(options)["frames"];
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0]["frame"], 3);
  EXPECT_EQ(frames[0]["time"], 0.3);
  EXPECT_EQ(frames[1]["frame"], 0);
  EXPECT_EQ(frames[1]["slices"], 24);
  EXPECT_TRUE(frames[1]["error"].is_null());
  EXPECT_GT(frames[1]["frame_ms"]["median"], 0.0);
  const std::vector<std::string> measured = joined(options, {"--error", "full"});
  EXPECT_GT(render(measured)["frames"][0]["error"]["pixels"], 0);
  // All are there already.
  EXPECT_TRUE(render(joined(measured, {"--skip-existing"}))["frames"].empty());
  expect_refused({"submit", "openjd", scene_, "--frames", "0", "-o", file("f_%d.exr"), "--stats",
                  file("s.json")},
                 {"--stats"});
}

// Sequences of volumes, fitted, as they are seen.

const std::filesystem::path volumes = BRUME_VOLUMES;

// A volume as it is: a Gaussian for each voxel, of its mass, wide enough that they add up evenly.
std::vector<Gaussian> voxels_of(const DensityGrid& grid) {
  const double radius = 0.75 * std::cbrt(grid.voxel_volume());
  const double peak = grid.voxel_volume() / std::pow(std::sqrt(std::numbers::pi) * radius, 3.0);
  std::vector<Gaussian> voxels;
  for (const DensityGrid::Block& block : grid.blocks) {
    for (int i = 0; i < static_cast<int>(DensityGrid::block_size); ++i) {
      const double density = static_cast<double>(block.values[static_cast<std::size_t>(i)]);
      const glm::ivec3 voxel = block.corner + glm::ivec3(i / 64, i / 8 % 8, i % 8);
      if (density > 0.0) voxels.push_back({grid.to_world(voxel), radius, peak * density});
    }
  }
  return voxels;
}

// Shows an entire volume, lit from the side.
Scene view_of(const DensityGrid& grid) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const Gaussian& voxel : voxels_of(grid)) {
    low = glm::min(low, voxel.center);
    high = glm::max(high, voxel.center);
  }
  const glm::dvec3 center = 0.5 * (low + high);
  const double size = glm::length(high - low);
  Scene scene;
  scene.film = {32, 32};
  scene.camera = {center + size * glm::dvec3(1.3, 0.4, 0.9), center, {0.0, 0.0, 1.0}, 45.0};
  scene.lights = {{center + size * glm::dvec3(-0.7, 1.0, 0.8), glm::dvec3(size * size), {}}};
  return scene;
}

std::vector<float> picture(Scene view, const std::vector<Gaussian>& gaussians) {
  for (const Gaussian& gaussian : gaussians) view.medium.append(gaussian);
  return render_frame(view, sliced_settings({}, 64)).airlight;
}

std::vector<float> difference(const std::vector<float>& a, const std::vector<float>& b) {
  std::vector<float> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

double norm(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += static_cast<double>(value) * static_cast<double>(value);
  return std::sqrt(sum);
}

// A picture of the Gaussians changes from frame to frame as much as one of the smoke itself, within
// the 10% that the project promises; and what it changes otherwise than the smoke, which is seen as
// flicker, is less than where each frame is fitted by itself.
TEST(SequenceView, FittedSmokeDoesNotFlicker) {
  VolumeFit how;
  how.options.count = 60;
  VolumeFitter fitter(how);
  const FittedVolume first = *fitter.next(volumes / "smoke_0025.vdb");
  const FittedVolume second = *fitter.next(volumes / "smoke_0026.vdb");
  const FittedVolume by_itself = *VolumeFitter(how).next(volumes / "smoke_0026.vdb");
  const Scene view = view_of(first.grid);
  const std::vector<float> before = picture(view, first.fit.gaussians);
  const std::vector<float> smoke =
      difference(picture(view, voxels_of(second.grid)), picture(view, voxels_of(first.grid)));
  const std::vector<float> fog = difference(picture(view, second.fit.gaussians), before);
  const std::vector<float> anew = difference(picture(view, by_itself.fit.gaussians), before);
  EXPECT_NEAR(norm(fog) / norm(smoke), 1.0, 0.1);
  EXPECT_LT(norm(difference(fog, smoke)), 0.9 * norm(difference(anew, smoke)));
}

}  // namespace

}  // namespace brume
