#include <cstring>

#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

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
  expect_region_matches({"--airlight", "auto", "--backend", "cpu", "--error", "none"});
  expect_region_matches({"--airlight", "sliced", "--backend", "cpu", "--airlight-scale", "4",
                         "--scattering", "single", "--layers", "lights,normal,motion"});
}

TEST_F(RegionAndCamera, OpenGlRendersItsPartOfThePicture) {
  expect_region_matches(
      {"--airlight", "sliced", "--backend", "gl", "--samples", "1", "--scattering", "single"});
}

TEST_F(RegionAndCamera, RefusesOtherRegions) {
  for (const char* region : {"", "0,0,1", "0,0,1,1,1", "0,0,1,x", "0.5,0,0.5,1", "0,1,1,0",
                             "-0.1,0,1,1", "0,0,1,1.1", "nan,0,1,1", "0 0 1 1"}) {
    if (*region == 0) continue;
    expect_refused({"render", scene_, "-o", file("o.exr"), "--region", region},
                   {"--region", "allowed: x0,y0,x1,y1"});
  }
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

}  // namespace
}  // namespace brume
