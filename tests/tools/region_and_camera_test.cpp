#include <cmath>

#include "tests/tools/command_line.h"

namespace brume {
namespace {

class RegionAndCamera : public CommandLine {
 protected:
  // Layers of a frame of the scene, rendered with these arguments.
  ImageLayers render(const std::string& scene, const std::vector<std::string>& arguments) const {
    std::vector<std::string> all{"render", scene, "-o", file("o.exr"), "--samples", "1"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const ProgramResult result = run_brume(all);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_exr(file("o.exr"));
  }

  // Differences of what `region` [x0, x0 + width) x ... shows of `whole`, relative to its maximum.
  static double max_difference(const ImageLayers& whole, const ImageLayers& region, int x0, int y0,
                               const std::string& channel) {
    const std::vector<float>& a = whole.channels.at(channel);
    const std::vector<float>& b = region.channels.at(channel);
    double most = 0.0;
    double scale = 0.0;
    for (int y = 0; y < region.height; ++y) {
      for (int x = 0; x < region.width; ++x) {
        const float expected = a[static_cast<std::size_t>((y0 + y) * whole.width + x0 + x)];
        const float found = b[static_cast<std::size_t>(y * region.width + x)];
        if (std::isinf(expected) && expected == found) continue;
        most = std::max(most, static_cast<double>(std::abs(expected - found)));
        scale = std::max(scale, static_cast<double>(std::abs(expected)));
      }
    }
    EXPECT_GT(scale, 0.0) << channel;
    return most / scale;
  }
};

constexpr const char* channels[] = {"R", "G", "A", "airlight.R", "transmittance.G", "Z"};

// Every pixel by itself: only the rounding of rays differs.
TEST_F(RegionAndCamera, ARegionShowsItsPartOfThePicture) {
  for (const char* method : {"march:16", "paper"}) {
    SCOPED_TRACE(method);
    const ImageLayers whole = render(scene_, {"--backend", "cpu", "--airlight", method});
    const ImageLayers region =
        render(scene_, {"--backend", "cpu", "--airlight", method, "--region", "0.25,0.5,0.7,1"});
    // 24 x 18 pixels.
    ASSERT_EQ(region.width, 11);
    ASSERT_EQ(region.height, 9);
    for (const char* channel : channels) {
      EXPECT_LT(max_difference(whole, region, 6, 9, channel), 1e-4) << channel;
    }
  }
}

TEST_F(RegionAndCamera, OpenGlRendersTheSameRegion) {
  const std::vector<std::string> sliced{"--airlight", "sliced", "--scattering", "single",
                                        "--backend"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), sliced.begin(), sliced.end());
    return render(scene_, more);
  };
  const ImageLayers whole = with({"cpu"});
  const ImageLayers region = with({"gl", "--region", "0.25,0.5,0.7,1"});
  for (const char* channel : channels) {
    // Single precision on the device, and edges of the floor half a pixel wide.
    EXPECT_LT(max_difference(whole, region, 6, 9, channel), 0.02) << channel;
  }
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
  const std::string scene = folder_.write("b.brume", named).string();
  const std::string behind =
      folder_.write("c.brume", std::string(text).replace(text.find("[0, 0, 5]"), 9, "[0, 0, -5]"))
          .string();
  const std::vector<std::string> paper{"--airlight", "paper"};
  const ImageLayers first = render(scene, paper);
  EXPECT_EQ(first.channels, render(scene, {"--airlight", "paper", "--camera", "Camera"}).channels);
  const ImageLayers other = render(scene, {"--airlight", "paper", "--camera", "From behind"});
  EXPECT_NE(first.channels, other.channels);
  EXPECT_NE(other.channels, render(behind, paper).channels);  // whose field of view is wider
  const ProgramResult info = run_brume({"info", scene});
  EXPECT_NE(info.out.find("cameras: Camera, From behind\n"), std::string::npos) << info.out;
  expect_refused({"render", scene, "-o", file("o.exr"), "--camera", "Front"},
                 {"--camera", "Front", "Camera, From behind"});
}

}  // namespace
}  // namespace brume
