// brume render --samples and --shutter.

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "core/io/image/image_file.h"
#include "tests/contains.h"
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
  expect_refused({"render", scene_, "-o", file("o.exr"), "--samples", "0"}, {"--samples"});
  expect_refused({"render", scene_, "-o", file("o.exr"), "--shutter", "0,1,2"},
                 {"--shutter", "allowed: OPEN,CLOSE"});
}

// brume render --scattering.

using Json = nlohmann::json;

// The error is of all of the light, against paths.
TEST_F(CommandLine, MeasuresAllOrdersOfScattering) {
  const auto stats_of = [&](const char* scattering) {
    expect_done({"render", scene_, "-o", file("o.exr"), "--stats", file("s.json"), "--size", "8x6",
                 "--airlight", "sliced", "--scattering", scattering});
    return Json::parse(content_of(folder_ / "s.json"));
  };
  const Json single = stats_of("single");
  EXPECT_TRUE(single["scattering"].is_null());
  const Json multiple = stats_of("multiple");
  EXPECT_GT(multiple["scattering"]["sweeps"], 0);
  EXPECT_LT(multiple["scattering"]["residual"], 1e-3);
  // A light in fog beside a surface, the hardest of what the grid holds.
  EXPECT_LT(multiple["error"]["low"], 0.1);
  EXPECT_LE(multiple["error"]["low"], multiple["error"]["rel_rmse"]);
  EXPECT_LE(multiple["error"]["rel_rmse"], multiple["error"]["high"]);
  const ProgramResult wrong =
      run_brume({"render", scene_, "-o", file("w.exr"), "--scattering", "twice"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(contains(wrong.err, "--scattering: found twice; allowed: single, multiple"));
}

class RegionAndCamera : public CommandLine {
 protected:
  // Layers of a frame of the scene, rendered with these arguments.
  ImageLayers render(const std::string& scene, const std::vector<std::string>& arguments) const {
    expect_done(joined({"render", scene, "-o", file("o.exr")}, arguments));
    return read_exr(file("o.exr"));
  }

  // Whether the region of a picture of 96 x 64 pixels is the same to the last bit.
  void expect_region_matches(std::vector<std::string> arguments) const {
    SCOPED_TRACE(arguments[1] + " " + arguments[3]);
    arguments = joined(arguments, {"--size", "96x64"});
    const ImageLayers whole = render(scene_, arguments);
    const ImageLayers region = render(scene_, joined(arguments, {"--region", "0.25,0.5,0.7,1"}));
    ASSERT_EQ(region.width, 44);
    ASSERT_EQ(region.height, 32);
    ASSERT_EQ(region.channels.size(), whole.channels.size());
    for (const auto& [name, values] : region.channels) {
      std::vector<float> expected;
      for (int y = 32; y < 64; ++y) {
        const auto row = whole.channels.at(name).begin() + 96 * y + 24;
        expected.insert(expected.end(), row, row + 44);
      }
      EXPECT_EQ(std::memcmp(values.data(), expected.data(), values.size() * sizeof(float)), 0)
          << name;
    }
  }
};

TEST_F(RegionAndCamera, ARegionShowsItsPartOfThePicture) {
  // The renderer's own tests hold it for each method (Regions).
  expect_region_matches({"--airlight", "sliced", "--backend", "cpu", "--airlight-scale", "4",
                         "--scattering", "single", "--layers", "lights,normal,motion"});
}

TEST_F(RegionAndCamera, OpenGlRendersItsPartOfThePicture) {
  expect_region_matches(
      {"--airlight", "sliced", "--backend", "gl", "--samples", "1", "--scattering", "single"});
}

TEST_F(RegionAndCamera, DenoisesWholePicturesOfPaths) {
  const std::vector<std::string> denoised{"render", scene_,  "-o",        file("o.exr"),
                                          "--size", "24x18", "--denoise", "solved"};
  expect_done(joined(denoised, {"--airlight", "path:2"}));
  for (const std::vector<std::string>& others :
       {std::vector<std::string>{"--airlight", "sliced"},
        {"--airlight", "path:1"},
        {"--airlight", "path:8", "--region", "0,0,0.5,0.5"},
        {"--airlight", "path:8", "--layers", "lights"}}) {
    expect_refused(joined(denoised, others), {"--denoise", "allowed"});
  }
}

TEST_F(RegionAndCamera, RefusesOtherRegions) {
  expect_refused({"render", scene_, "-o", file("o.exr"), "--region", "0.5,0,0.5,1"},
                 {"--region", "allowed: x0,y0,x1,y1"});
}

TEST_F(RegionAndCamera, ANamedCameraSeesTheScene) {
  const std::string text = scene_text;
  const std::string named =
      R"({ "cameras": [ { "name": "From behind", "eye": [0, 0, -5], "vertical_fov": 30 } ],)" +
      text.substr(1);
  const std::string scene = folder_.write("b.brume", named);
  const std::string behind =
      folder_.write("c.brume", std::string(text).replace(text.find("[0, 0, 5]"), 9, "[0, 0, -5]"));
  const auto seen_by = [&](const std::string& camera) {
    return render(scene, {"--airlight", "paper", "--samples", "1", "--camera", camera});
  };
  const std::vector<std::string> paper{"--airlight", "paper", "--samples", "1"};
  const ImageLayers first = render(scene, paper);
  EXPECT_EQ(first.channels, seen_by("Camera").channels);
  const ImageLayers other = seen_by("From behind");
  EXPECT_NE(first.channels, other.channels);
  EXPECT_NE(other.channels, render(behind, paper).channels);  // whose field of view is wider
  const ProgramResult info = run_brume({"info", scene});
  EXPECT_TRUE(contains(info.out, "cameras: Camera, From behind\n"));
  expect_refused({"render", scene, "-o", file("o.exr"), "--camera", "Front"},
                 {"--camera", "Front", "Camera, From behind"});
}

class LayersOption : public CommandLine {
 protected:
  [[nodiscard]] ImageLayers render(const std::vector<std::string>& options) const {
    expect_done(joined(
        {"render", scene_, "-o", file("a.exr"), "--airlight", "sliced", "--scattering", "single"},
        options));
    return read_exr(folder_ / "a.exr");
  }
};

TEST_F(LayersOption, AddsLayersToThose) {
  const ImageLayers image =
      render({"--layers",
              "lights,reflection,optical_depth,normal,albedo,position,motion,objects,materials"});
  for (const char* name :
       {"R", "Z", "airlight.R", "airlight.light_1.R", "surface.light_1.B", "reflection.B",
        "optical_depth.G", "normal.X", "albedo.R", "position.Z", "forward.u", "CryptoObject00.R",
        "CryptoObject02.A", "CryptoMaterial01.G"}) {
    EXPECT_TRUE(image.channels.contains(name)) << name;
  }
  std::size_t manifests = 0;
  for (const auto& [name, text] : image.metadata) {
    if (!name.ends_with("/manifest")) continue;
    ++manifests;
    EXPECT_EQ(nlohmann::json::parse(text).size(), 1u) << text;
  }
  EXPECT_EQ(manifests, 2u);
}

// With commands of the manual.
TEST_F(LayersOption, OiiotoolRebuildsThePicture) {
  static_cast<void>(render({"--layers", "lights"}));
  const std::string command =
      "cd " + quoted(folder_.path().string()) + " && " + quoted(BRUME_OIIOTOOL) +
      " -i:ch=airlight.light_1.R,airlight.light_1.G,airlight.light_1.B a.exr --chnames R,G,B"
      " -i:ch=surface.light_1.R,surface.light_1.G,surface.light_1.B a.exr --chnames R,G,B --add"
      " -o sum.exr >oiio.txt 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << content_of(folder_ / "oiio.txt");
  const ImageLayers sum = read_exr(folder_ / "sum.exr");
  const ImageLayers whole = read_exr(folder_ / "a.exr");
  for (const char* name : {"R", "G", "B"}) {
    const std::vector<float>& picture = whole.channels.at(name);
    for (std::size_t i = 0; i < picture.size(); ++i) {
      EXPECT_NEAR(sum.channels.at(name)[i], picture[i], 1e-6 * std::max(picture[i], 1.0f));
    }
  }
}

TEST_F(LayersOption, NamesWhatIsAllowed) {
  const std::string image = file("a.exr");
  expect_refused(
      {"render", scene_, "-o", image, "--layers", "lights,lamps"},
      {"--layers: found", "allowed: airlight, transmittance, Z, lights", "objects, materials"});
  expect_refused({"render", scene_, "-o", file("a.png"), "--layers", "lights"},
                 {"--layers", "flat EXR"});
  expect_refused({"render", scene_, "-o", image, "--size", "16384x16384", "--layers", "objects"},
                 {"layers: ", "bytes"});
  EXPECT_FALSE(std::filesystem::exists(image));
}

}  // namespace

}  // namespace brume
