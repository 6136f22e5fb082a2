// Frame n is at n / F seconds for every subcommand: F is that of the scene's timeline, else 30,
// unless --fps gives another.

#include <nlohmann/json.hpp>

#include "core/io/gaussians/gaussian_file.h"
#include "core/number_domain.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

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
    EXPECT_TRUE(contains(usd, "timeCodesPerSecond = " + number + "\n"));
    EXPECT_TRUE(contains(usd, "6: " + transform(stage(scene, time))));
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
