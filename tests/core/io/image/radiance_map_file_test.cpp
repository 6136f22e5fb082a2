#include "core/io/image/radiance_map_file.h"

#include <gtest/gtest.h>

#include "core/io/image/hdr_file.h"
#include "core/io/image/image_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

std::string hdr_header(int width, int height, const std::string& more = "") {
  return "#?RADIANCE\n# made by a test\nFORMAT=32-bit_rle_rgbe\n" + more + "\n-Y " +
         std::to_string(height) + " +X " + std::to_string(width) + "\n";
}

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

using HdrFile = FolderTest;

TEST_F(HdrFile, ReadsFlatPixels) {
  // Exponent 136 is a unit of 1; 128 one of 1/256.
  const RadianceMap map = read_hdr(folder_.write(
      "a.hdr",
      hdr_header(2, 2) + bytes({10, 20, 30, 136, 255, 0, 128, 128, 9, 9, 9, 0, 1, 1, 2, 137})));
  ASSERT_EQ(map.width, 2);
  ASSERT_EQ(map.height, 2);
  EXPECT_EQ(map.pixel(0, 0), glm::vec3(10.5f, 20.5f, 30.5f));
  EXPECT_EQ(map.pixel(1, 0), glm::vec3(255.5f, 0.5f, 128.5f) / 256.0f);
  EXPECT_EQ(map.pixel(0, 1), glm::vec3(0.0f)) << "exponent 0 is black";
  EXPECT_EQ(map.pixel(1, 1), glm::vec3(3.0f, 3.0f, 5.0f));
}

TEST_F(HdrFile, UndoesTheExposure) {
  const RadianceMap map =
      read_hdr(folder_.write("a.hdr", hdr_header(1, 1, "EXPOSURE= 4\nGAMMA=1\nEXPOSURE=0.5\n") +
                                          bytes({10, 20, 30, 136})));
  EXPECT_EQ(map.pixel(0, 0), glm::vec3(5.25f, 10.25f, 15.25f));
}

TEST_F(HdrFile, UndoesTheColorCorrection) {
  const RadianceMap map = read_hdr(
      folder_.write("a.hdr", hdr_header(1, 1, "EXPOSURE = 2\nCOLORCORR= 1 2 .5\n# EXPOSURE=9\n") +
                                 bytes({10, 20, 30, 136})));
  EXPECT_EQ(map.pixel(0, 0), glm::vec3(5.25f, 5.125f, 30.5f));
}

TEST_F(HdrFile, ReadsRowsInAnyOrder) {
  // The picture, of three by two pixels, from the top: 1 2 3, 4 5 6.
  const std::pair<const char*, std::vector<int>> orders[] = {
      {"-Y 2 +X 3", {1, 2, 3, 4, 5, 6}}, {"-Y 2 -X 3", {3, 2, 1, 6, 5, 4}},
      {"+Y 2 +X 3", {4, 5, 6, 1, 2, 3}}, {"+Y 2 -X 3", {6, 5, 4, 3, 2, 1}},
      {"+X 3 -Y 2", {1, 4, 2, 5, 3, 6}}, {"+X 3 +Y 2", {4, 1, 5, 2, 6, 3}},
      {"-X 3 -Y 2", {3, 6, 2, 5, 1, 4}}, {"-X 3 +Y 2", {6, 3, 5, 2, 4, 1}}};
  for (const auto& [size, order] : orders) {
    std::string pixels;
    for (const int value : order) pixels += bytes({value, 0, 0, 136});
    const RadianceMap map =
        read_hdr(folder_.write("a.hdr", std::string("#?RGBE\n\n") + size + "\n" + pixels));
    ASSERT_EQ(map.width, 3) << size;
    ASSERT_EQ(map.height, 2) << size;
    for (int i = 0; i < 6; ++i) {
      EXPECT_EQ(map.pixel(i % 3, i / 3).x, static_cast<float>(i) + 1.5f) << size;
    }
  }
}

TEST_F(HdrFile, ReadsHeadersOfOldPrograms) {
  const std::string pixel = bytes({10, 20, 30, 136});
  for (const std::string& header :
       {std::string("#?RGBE\n\n-Y 1 +X 1\n"),
        std::string("#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n"),
        std::string("#?RADIANCE\npfilt -x 1\nFORMAT= 32-bit_rle_rgbe \n \n\n-Y 1 +X 1\n"),
        std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n-Y 1 +X 1\n")}) {
    EXPECT_EQ(read_hdr(folder_.write("a.hdr", header + pixel)).pixel(0, 0).x, 10.5f) << header;
    EXPECT_EQ(read_hdr(folder_.write("a.hdr", header + pixel + "behind")).pixel(0, 0).x, 10.5f);
  }
}

TEST_F(HdrFile, ReadsTheOldRuns) {
  // A count of 3 + 256 in two pixels.
  const RadianceMap map = read_hdr(folder_.write(
      "a.hdr",
      hdr_header(261, 1) + bytes({10, 20, 30, 136, 1, 1, 1, 3, 1, 1, 1, 1, 40, 20, 30, 136})));
  EXPECT_EQ(map.pixel(259, 0).x, 10.5f);
  EXPECT_EQ(map.pixel(260, 0).x, 40.5f);
}

TEST_F(HdrFile, ReadsTheNewRuns) {
  std::string data = hdr_header(8, 2);
  for (int row = 0; row < 2; ++row) {
    data += bytes({2, 2, 0, 8});
    data += bytes({128 + 8, 10 + row});                        // red: one run
    data += bytes({3, 1, 2, 3, 128 + 4, 4, 1, 5});             // green: both
    data += bytes({8, 0, 1, 2, 3, 4, 5, 6, 7, 128 + 8, 136});  // blue: one stretch
  }
  const RadianceMap map = read_hdr(folder_.write("a.hdr", data));
  EXPECT_EQ(map.pixel(0, 0), glm::vec3(10.5f, 1.5f, 0.5f));
  EXPECT_EQ(map.pixel(6, 1), glm::vec3(11.5f, 4.5f, 6.5f));
  EXPECT_EQ(map.pixel(7, 1), glm::vec3(11.5f, 5.5f, 7.5f));
}

TEST_F(HdrFile, RefusesWhatItIsNot) {
  const std::string pixel = bytes({10, 20, 30, 136});
  const std::string bad_header = "#?RADIANCE\n\n";
  const std::string new_row = bytes({2, 2, 0, 8});
  const std::pair<std::string, std::string> cases[] = {
      {"PNG", "line 1"},
      {"#?RADIANCE\n", "line 1"},
      {"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + pixel, "32-bit_rle_rgbe"},
      {hdr_header(1, 1, "EXPOSURE=0\n") + pixel, "exposure"},
      {hdr_header(1, 1, "EXPOSURE=nan\n") + pixel, "exposure"},
      {hdr_header(1, 1, "EXPOSURE=1e300\nEXPOSURE=1e300\n") + pixel, "exposures"},
      {bad_header + "+Y 1 -Y 1\n" + pixel, "-Y HEIGHT +X WIDTH"},
      {bad_header + "Y 1 X 1\n" + pixel, "-Y HEIGHT +X WIDTH"},
      {hdr_header(1, 1, "COLORCORR=1 1\n") + pixel, "exposure of 1 1"},
      {bad_header + "-Y 0 +X 1\n", "line 3"},
      {bad_header + "-Y 1 +X 99999\n", "32768"},
      {bad_header + "-Y 32768 +X 32768\n" + pixel, "too short"},
      {bad_header, "before the size"},
      {hdr_header(2, 1) + pixel, "row 0"},
      {hdr_header(1, 2) + pixel, "row 1"},
      {hdr_header(2, 1) + bytes({1, 1, 1, 1}) + pixel, "without a pixel"},
      {hdr_header(2, 1) + pixel + bytes({1, 1, 1, 9}), "beyond"},
      {hdr_header(8, 1) + bytes({2, 2, 0, 9}), "width of 9"},
      {hdr_header(8, 1) + new_row + bytes({0}), "run of 0"},
      {hdr_header(8, 1) + new_row + bytes({7, 1, 1, 1, 1, 1, 1, 1, 130, 1}), "column 7"},
      {hdr_header(8, 1) + new_row + bytes({136}), "ends here"},
  };
  for (const auto& [content, part] : cases) {
    const std::filesystem::path file = folder_.write("bad.hdr", content);
    const std::string error = error_of([&] { read_hdr(file); });
    EXPECT_TRUE(contains(error, part)) << part << " in: " << error;
    EXPECT_TRUE(contains(error, "bad.hdr"));
  }
}

TEST_F(HdrFile, NoDamageDoesAnythingButAnError) {
  const std::string complete =
      hdr_header(8, 1) + bytes({2, 2, 0, 8, 136, 1, 136, 2, 3, 1, 2, 3, 133, 4, 136, 9});
  const auto read = [&](const std::string& bytes) { read_hdr(folder_.write("a.hdr", bytes)); };
  EXPECT_NO_THROW(read(complete));
  expect_truncations_refused(complete, read);
  refused_damages(complete, read);
}

ImageLayers sky() {
  ImageLayers image;
  image.width = 2;
  image.height = 1;
  image.channels = {{"R", {1.0f, 2.0f}}, {"G", {3.0f, 4.0f}}, {"B", {5.0f, -1e-4f}}};
  return image;
}

TEST(RadianceMapFile, ReadsEitherFormat) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", sky());
  const auto map = read_radiance_map(folder / "a.exr");
  ASSERT_EQ(map->width, 2);
  EXPECT_EQ(map->pixel(0, 0), glm::vec3(1, 3, 5));
  EXPECT_EQ(map->pixel(1, 0), glm::vec3(2, 4, 0)) << "below 0 is 0";
  folder.write("a.hdr", hdr_header(1, 1) + bytes({10, 20, 30, 136}));
  EXPECT_EQ(read_radiance_map(folder / "a.hdr")->pixel(0, 0), glm::vec3(10.5f, 20.5f, 30.5f));
}

TEST(RadianceMapFile, RefusesWhatCannotLightAScene) {
  const TemporaryFolder folder;
  const auto error = [&](const ImageLayers& image) {
    write_exr(folder / "bad.exr", image);
    return error_of([&] { read_radiance_map(folder / "bad.exr"); });
  };
  ImageLayers image = sky();
  image.channels["G"][1] = 2e20f;
  EXPECT_TRUE(contains(error(image), "pixel (1, 0): found 2"));
  image.channels["G"][1] = -3e38f;
  EXPECT_TRUE(contains(error(image), "pixel (1, 0)"));
  image.channels.erase("G");
  EXPECT_TRUE(contains(error(image), "no channels R G B or Y; its channels: B R"));
  expect_error([&] { read_radiance_map(folder.write("not.exr", "PNG")); }, "neither an OpenEXR");
}

}  // namespace
}  // namespace brume
