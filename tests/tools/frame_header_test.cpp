// The header of an EXR describes the frame, as OpenImageIO reads it.

#include <nlohmann/json.hpp>

#include "core/io/gaussians/gaussian_file.h"
#include "core/number_domain.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

class FrameHeader : public CommandLine {
 protected:
  // Lines of `oiiotool --info -v`.
  std::string header(const char* image) const {
    const std::string command = quoted(BRUME_OIIOTOOL) + " --info -v " + quoted(file(image)) +
                                " >" + quoted(file("info.txt"));
    EXPECT_EQ(std::system(command.c_str()), 0);
    return content_of(folder_ / "info.txt");
  }
  // The 16 numbers of a matrix there.
  static std::vector<double> matrix(const std::string& header, const std::string& name) {
    const std::size_t place = header.find(name + ": ");
    EXPECT_NE(place, std::string::npos) << header;
    if (place == std::string::npos) return std::vector<double>(16, 0.0);
    std::istringstream text(header.substr(place + name.size() + 2));
    std::vector<double> numbers;
    for (std::string number; numbers.size() < 16 && text >> number;) {
      numbers.push_back(std::stod(number));
    }
    return numbers;
  }
  // A point as a row times the matrix, divided by w.
  static std::array<double, 3> mapped(const std::vector<double>& m, std::array<double, 3> p) {
    std::array<double, 4> result{};
    for (std::size_t j = 0; j < 4; ++j) {
      result[j] = p[0] * m[j] + p[1] * m[4 + j] + p[2] * m[8 + j] + m[12 + j];
    }
    return {result[0] / result[3], result[1] / result[3], result[2] / result[3]};
  }
  void render(std::vector<std::string> more) const {
    expect_done(joined({"render", scene_, "--backend", "cpu", "--size", "40x20"}, more));
  }
};

TEST_F(FrameHeader, HasSettingsTimeAndRate) {
  render({"--airlight", "sliced", "--scattering", "single", "--slices", "16", "--samples", "4",
          "--frames", "12", "--fps", "23.976", "--error", "full", "-o", file("f_%d.exr")});
  const std::string sliced = header("f_12.exr");
  for (const char* line :
       {"brume:slices: \"16\"", "brume:samples: \"4\"", "brume:frame: \"12\"", "brume:time: \"0.5",
        "framesPerSecond: 24000/1001", "brume:error: \"0."}) {
    EXPECT_TRUE(contains(sliced, line)) << line << " in " << sliced;
  }
  EXPECT_FALSE(contains(sliced, "brume:seed"));
  render({"--airlight", "path:2", "--seed", "7", "--time", "-2.5", "-o", file("p.exr")});
  const std::string traced = header("p.exr");
  for (const char* line : {"brume:seed: \"7\"", "brume:time: \"-2.5\"", "framesPerSecond: 30/1"}) {
    EXPECT_TRUE(contains(traced, line)) << line << " in " << traced;
  }
  for (const char* line : {"brume:slices", "brume:frame:", "brume:error"}) {
    EXPECT_FALSE(contains(traced, line));
  }
}

// The camera is at (0, 0, 5) and looks along -z, 45 degrees from top to bottom.
TEST_F(FrameHeader, HasTheMatricesOfTheCamera) {
  for (const char* image : {"a.exr", "a.deep.exr"}) {
    SCOPED_TRACE(image);
    render({"--airlight", "sliced", "--scattering", "single", "-o", file(image)});
    const std::string text = header(image);
    const auto seen = mapped(matrix(text, "worldToCamera"), {1, 2, 3});
    EXPECT_NEAR(seen[0], 1.0, 1e-6);
    EXPECT_NEAR(seen[1], 2.0, 1e-6);
    EXPECT_NEAR(seen[2], 2.0, 1e-6);
    const auto place = mapped(matrix(text, "worldToNDC"), {0.5, 0.25, 3});
    const double slope = 1.0 / std::tan(22.5 * 3.14159265358979 / 180.0);
    EXPECT_NEAR(place[0], 0.5 + 0.5 * 0.5 * (0.5 / 2.0) * slope, 1e-6);
    EXPECT_NEAR(place[1], 0.5 - 0.5 * (0.25 / 2.0) * slope, 1e-6);
  }
}

// An orthographic one, 4 u high: points are not divided by their depth.
TEST_F(FrameHeader, HasTheMatricesOfAnOrthographicCamera) {
  folder_.write_scene("map.brume",
                      R"("camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "height": 4})");
  for (const char* image : {"a.exr", "a.deep.exr"}) {
    SCOPED_TRACE(image);
    expect_done({"render", file("map.brume"), "--backend", "cpu", "--size", "40x20", "--airlight",
                 "sliced", "-o", file(image)});
    const std::string text = header(image);
    const auto seen = mapped(matrix(text, "worldToCamera"), {1, 2, 3});
    EXPECT_NEAR(seen[0], 1.0, 1e-6);
    EXPECT_NEAR(seen[1], 2.0, 1e-6);
    EXPECT_NEAR(seen[2], 2.0, 1e-6);
    for (const double z : {3.0, -40.0}) {
      const auto place = mapped(matrix(text, "worldToNDC"), {0.5, 0.25, z});
      EXPECT_NEAR(place[0], 0.5 + 0.5 / 8.0, 1e-6);
      EXPECT_NEAR(place[1], 0.5 - 0.25 / 4.0, 1e-6);
    }
  }
}

// The position of a pixel of a part of the picture comes back to the pixel.
TEST_F(FrameHeader, HasTheMatricesOfARegion) {
  render({"--airlight", "sliced", "--scattering", "single", "--layers", "position", "--region",
          "0.25,0.5,1,1", "-o", file("a.exr")});
  const std::vector<double> to_ndc = matrix(header("a.exr"), "worldToNDC");
  const ImageLayers image = read_exr(folder_ / "a.exr");
  std::size_t found = 0;
  for (std::size_t i = 0; i < image.channels.at("Z").size(); ++i) {
    if (std::isinf(image.channels.at("Z")[i])) continue;
    ++found;
    const auto at = [&](const char* name) {
      return static_cast<double>(image.channels.at(name)[i]);
    };
    const auto place = mapped(to_ndc, {at("position.X"), at("position.Y"), at("position.Z")});
    EXPECT_NEAR(place[0] * image.width, static_cast<double>(i % image.width) + 0.5, 1e-3);
    EXPECT_NEAR(place[1] * image.height, static_cast<double>(i / image.width) + 0.5, 1e-3);
  }
  EXPECT_GT(found, 20u);
}

// Frame n is at n / F seconds for every subcommand: F is that of the scene's timeline, else 30,
// unless --fps gives another.

using Json = nlohmann::json;

class FrameRate : public CommandLine {
 protected:
  // A camera and a light that move; `timeline`: frames per second, if any.
  std::string moving(std::optional<double> timeline) {
    Json scene = Json::parse(scene_text);
    const auto keys = [](const Json& from, const Json& to) {
      return Json::array({{{"time", 0}, {"value", from}}, {{"time", 10}, {"value", to}}});
    };
    scene["camera"]["keys"] = {{"eye", keys({0, 0, 5}, {40, 0, 5})}};
    scene["lights"][0]["keys"] = {{"intensity", keys({0, 0, 60}, {60, 0, 0})}};
    scene["medium"]["emitters"] = {{{"position", {0, 0, 0}}, {"rate", 5}, {"lifetime", 5}}};
    if (timeline) scene["timeline"] = {{"last", 99}, {"frames_per_second", *timeline}};
    return folder_.write("moving.brume", scene.dump());
  }

  std::map<std::string, std::vector<float>> rendered(const std::string& scene, const char* image,
                                                     std::vector<std::string> more) {
    more = joined(words("--airlight sliced --backend cpu --size 8x6 --scattering single"), more);
    expect_done(joined({"render", scene, "-o", file(image)}, more));
    return read_exr(folder_ / (image == std::string("f_%d.exr") ? "f_6.exr" : image)).channels;
  }

  std::vector<Gaussian> exported(const std::string& scene, const char* output,
                                 std::vector<std::string> more) {
    expect_done(joined({"export", scene, "-o", file(output)}, more));
    return read_gaussians(file(output == std::string("f_%d.ply") ? "f_6.ply" : output));
  }

  std::string stage(const std::string& scene, const std::vector<std::string>& more) {
    expect_done(joined({"export", scene, "-o", file("f.usda"), "--voxel", "0.2"}, more));
    return content_of(folder_ / "f.usda");
  }
  // The camera's transform in a stage of one moment.
  static std::string transform(const std::string& stage) {
    const std::string begin = "xformOp:transform = ";
    const std::size_t place = stage.find(begin, stage.find("def Camera")) + begin.size();
    return stage.substr(place, stage.find('\n', place) - place);
  }

  // The rate that submit gives ffmpeg.
  std::string video_rate(const std::string& scene, std::vector<std::string> more) {
    more = joined({"-o", file("v_%d.png"), "--video", file("film.mp4")}, more);
    expect_done(joined({"submit", "openjd", scene, "--frames", "0-3"}, more));
    const Json job = Json::parse(content_of(folder_ / "v.openjd/template.json"));
    const Json words = job["steps"][1]["script"]["actions"]["onRun"]["args"];
    const auto rate = std::ranges::find(words, Json("-framerate"));
    return rate == words.end() ? "" : (rate + 1)->get<std::string>();
  }
};

struct RateCase {
  std::optional<double> timeline;
  std::vector<std::string> options;
  double frames_per_second;
};

TEST_F(FrameRate, IsOneForAllSubcommands) {
  for (const RateCase& c :
       {RateCase{{}, {}, 30.0}, RateCase{12.0, {}, 12.0}, RateCase{12.0, {"--fps", "24"}, 24.0},
        RateCase{{}, {"--fps", "10"}, 10.0}}) {
    SCOPED_TRACE(c.frames_per_second);
    const std::string scene = moving(c.timeline);
    const std::vector<std::string> time{"--time", Json(6.0 / c.frames_per_second).dump()};
    const std::vector<std::string> frame = joined({"--frames", "6"}, c.options);
    EXPECT_EQ(rendered(scene, "f_%d.exr", frame), rendered(scene, "alone.exr", time));
    EXPECT_EQ(exported(scene, "f_%d.ply", frame), exported(scene, "alone.ply", time));
    const std::string usd = stage(scene, joined({"--frames", "6-7"}, c.options));
    const std::string number = quoted_text(c.frames_per_second);
    EXPECT_TRUE(contains(usd, "timeCodesPerSecond = " + number + "\n",
                         "6: " + transform(stage(scene, time))));
    EXPECT_EQ(video_rate(scene, c.options), number);
  }
}

TEST_F(FrameRate, OfTheOptionReachesShuttersAndMotionVectors) {
  const auto blurred = [this](double timeline, const std::string& more) {
    return rendered(moving(timeline), "a.exr",
                    words("--samples 8 --shutter 0,1 --layers motion --time 0.5" + more));
  };
  const auto by_timeline = blurred(10.0, "");
  const auto by_option = blurred(40.0, " --fps 10");
  EXPECT_EQ(by_option, by_timeline);
  const auto faster = blurred(40.0, "");
  EXPECT_NE(faster.at("R"), by_timeline.at("R"));
  // Where nothing is hit the direction moves by how far the camera turns, nearly in proportion.
  EXPECT_NEAR(by_timeline.at("forward.u")[0] / faster.at("forward.u")[0], 4.0, 0.5);
}

// Frames of another rate are others, at whatever option they come from.
TEST_F(FrameRate, CountsForWhatIsCurrent) {
  const auto made = [this](std::optional<double> timeline, std::vector<std::string> more) {
    more = joined(words("--airlight sliced --scattering single --size 4x3 --frames 1-2"), more);
    const ProgramResult result = expect_done(
        joined({"render", moving(timeline), "-o", file("s_%d.exr"), "--skip-existing"}, more));
    return Json::parse(result.out)["made"].size();
  };
  EXPECT_EQ(made({}, {}), 2u);
  EXPECT_EQ(made({}, {"--fps", "30"}), 0u);
  EXPECT_EQ(made({}, {"--fps", "24"}), 2u);
}

}  // namespace

}  // namespace brume
