// The header of an EXR describes the frame, as OpenImageIO reads it.

#include <nlohmann/json.hpp>

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

}  // namespace
}  // namespace brume
