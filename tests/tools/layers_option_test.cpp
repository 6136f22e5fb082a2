#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/io/image/image_file.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

class LayersOption : public CommandLine {
 protected:
  [[nodiscard]] ImageLayers render(const std::vector<std::string>& options) const {
    expect_done(joined(
        {"render", scene_, "-o", file("a.exr"), "--airlight", "sliced", "--scattering", "single"},
        options));
    return read_exr(folder_ / "a.exr");
  }
};

TEST_F(LayersOption, WithoutItTheLayersAreThoseOfTheContract) {
  const ImageLayers image = render({});
  std::vector<std::string> names;
  for (const auto& [name, values] : image.channels) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"A", "B", "G", "R", "Z", "airlight.B", "airlight.G",
                                             "airlight.R", "transmittance.B", "transmittance.G",
                                             "transmittance.R"}));
}

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
  for (const char* names : {"lamps", "lights,", "lights,lamps", "Lights", "lights, normal"}) {
    expect_refused(
        {"render", scene_, "-o", image, "--layers", names},
        {"--layers: found", "allowed: airlight, transmittance, Z, lights", "objects, materials"});
  }
  expect_refused({"render", scene_, "-o", file("a.png"), "--layers", "lights"},
                 {"--layers", "flat EXR"});
  expect_refused({"render", scene_, "-o", image, "--size", "16384x16384", "--layers", "objects"},
                 {"layers: ", "bytes"});
  EXPECT_FALSE(std::filesystem::exists(image));
}

}  // namespace
}  // namespace brume
