// brume render --samples and --shutter.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/tools/command_line.h"

namespace brume {
namespace {

using Json = nlohmann::json;

class SamplesOption : public CommandLine {
 protected:
  // Without homogeneous fog, which hides where the floor ends: it lets nothing through to infinity.
  SamplesOption() { scene_ = folder_.write("a.brume", clear_text()); }
  static std::string clear_text() {
    std::string text = scene_text;
    const std::string density = "\"density\": 0.02, ";
    return text.erase(text.find(density), density.size());
  }
  struct Rendered {
    ImageLayers image;
    Json stats;
  };
  Rendered render(const std::string& scene, std::vector<std::string> arguments) const {
    expect_done(joined({"render", scene, "-o", file("o.exr"), "--stats", file("s.json"),
                        "--scattering", "single", "--airlight", "sliced"},
                       arguments));
    return {read_exr(file("o.exr")), Json::parse(content_of(folder_ / "s.json"))};
  }
  // The scene with more members of its objects.
  [[nodiscard]] std::string with(const std::string& object, const std::string& members) const {
    std::string text = clear_text();
    const std::string begin = "\"" + object + "\": {";
    const std::size_t found = text.find(begin);
    if (found == std::string::npos)
      return folder_.write("b.brume", "{ \"" + object + "\": {" + members + "}," + text.substr(1));
    return folder_.write("b.brume", text.insert(found + begin.size(), members + ", "));
  }
};

// Pixels that the floor covers in part: there is more of it than of the fog alone, but not all.
int partly_covered(const ImageLayers& image) {
  int count = 0;
  const std::vector<float>& alpha = image.channels.at("A");
  const std::vector<float>& transmittance = image.channels.at("transmittance.G");
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    count += alpha[i] > 1.05F - transmittance[i] && alpha[i] < 0.995F;
  }
  return count;
}

TEST_F(SamplesOption, AreChosenByTheScene) {
  const Rendered chosen = render(scene_, {});
  EXPECT_EQ(chosen.stats["samples"], 16);
  EXPECT_GT(chosen.stats["sampled_pixels"], 20);
  const Rendered one = render(scene_, {"--samples", "1"});
  EXPECT_EQ(one.stats["samples"], 1);
  EXPECT_EQ(one.stats["sampled_pixels"], 0);
  EXPECT_NE(chosen.image.channels.at("R"), one.image.channels.at("R"));
  EXPECT_EQ(chosen.image.channels.at("Z"), one.image.channels.at("Z")) << "never filtered";
  EXPECT_GT(partly_covered(chosen.image), partly_covered(one.image));
  // The error is that of the same rays.
  EXPECT_NEAR(chosen.stats["error"]["rel_rmse"].get<double>(),
              one.stats["error"]["rel_rmse"].get<double>(),
              0.2 * one.stats["error"]["rel_rmse"].get<double>());

  std::string bare = clear_text();
  bare = bare.substr(0, bare.find(",\n  \"surfaces\"")) + "}";
  const std::string fog = folder_.write("fog.brume", bare);
  const Rendered plain = render(fog, {});
  EXPECT_EQ(plain.stats["samples"], 1);
  EXPECT_EQ(plain.image.channels, render(fog, {"--samples", "1"}).image.channels);

  const std::string own = with("output", R"("samples": 4)");
  EXPECT_EQ(render(own, {}).stats["samples"], 4);
  EXPECT_EQ(render(own, {"--samples", "8"}).stats["samples"], 8);
}

TEST_F(SamplesOption, AnApertureBlurs) {
  const std::string lens = with("camera", R"("aperture": 0.4, "focus_distance": 2)");
  const Rendered sharp = render(scene_, {});
  const Rendered blurred = render(lens, {"--samples", "16"});
  EXPECT_EQ(render(lens, {}).stats["samples"], 64);
  EXPECT_EQ(blurred.image.channels.at("Z"), sharp.image.channels.at("Z"));
  EXPECT_GT(partly_covered(blurred.image), 1.5 * partly_covered(sharp.image));
  EXPECT_EQ(render(lens, {"--samples", "1"}).image.channels,
            render(scene_, {"--samples", "1"}).image.channels);
}

TEST_F(SamplesOption, AShutterBlursWhatMoves) {
  const std::string moving = with("camera", R"("keys": {"eye": [{"time": 0, "value": [0, 0, 5]},
                                         {"time": 1, "value": [3, 0, 5]}]})");
  const std::vector<std::string> at{"--time", "0.5", "--samples", "8"};
  const Rendered still = render(moving, at);
  const ImageLayers smeared = render(moving, joined(at, {"--shutter", "0,2"})).image;
  EXPECT_NE(smeared.channels.at("R"), still.image.channels.at("R"));
  EXPECT_EQ(smeared.channels.at("Z"), still.image.channels.at("Z"));
  // Nothing moves: the same as without.
  EXPECT_EQ(render(scene_, words("--samples 8 --shutter 0,2")).image.channels,
            render(scene_, {"--samples", "8"}).image.channels);
  const std::string own = folder_.write(
      "c.brume", R"({ "output": {"shutter": [0, 2]},)" + content_of(moving).substr(1));
  EXPECT_EQ(render(own, at).image.channels, smeared.channels);
  EXPECT_EQ(render(own, joined(at, {"--shutter", "none"})).image.channels, still.image.channels);
}

TEST_F(SamplesOption, PathsAreShared) {
  expect_done({"render", scene_, "-o", file("p.exr"), "--stats", file("p.json"), "--airlight",
               "path:32", "--samples", "4"});
  EXPECT_EQ(Json::parse(content_of(folder_ / "p.json"))["noise"]["paths"], 32);
}

TEST_F(SamplesOption, RefuseMistakes) {
  for (const char* samples : {"0", "4097", "x", "1.5"}) {
    expect_refused({"render", scene_, "-o", file("o.exr"), "--samples", samples}, {"--samples"});
  }
  for (const char* shutter : {"0", "0,0", "1,0", "0,3", "a,b", "0,1,2", "0,nan", ","}) {
    expect_refused({"render", scene_, "-o", file("o.exr"), "--shutter", shutter},
                   {"--shutter", "allowed: OPEN,CLOSE"});
  }
}

}  // namespace
}  // namespace brume
