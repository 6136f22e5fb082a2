#include "core/io/image_file.h"

#include <ImfChannelList.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>
#include <half.h>
#include <png.h>
#include <sys/resource.h>

#include <cmath>
#include <limits>

#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

ImageLayers some_image() {
  ImageLayers image;
  image.width = 5;
  image.height = 3;
  for (const char* name : {"R", "G", "airlight.B", "Z"}) {
    for (int i = 0; i < 15; ++i) {
      image.channels[name].push_back(static_cast<float>(i) * 1.25f - name[0]);
    }
  }
  image.channels["Z"][4] = std::numeric_limits<float>::infinity();
  image.channels["R"][7] = 3.4e38f;
  image.metadata = {{"scene", "a b.brume"}, {"airlight", "paper"}};
  return image;
}

TEST(ExrFile, ReadsBackExactlyWhatWasWritten) {
  const TemporaryFolder folder;
  const ImageLayers image = some_image();
  write_exr(folder / "a.exr", image);
  const ImageLayers read = read_exr(folder / "a.exr");
  EXPECT_EQ(read.width, 5);
  EXPECT_EQ(read.height, 3);
  EXPECT_EQ(read.channels, image.channels);
  for (const auto& [key, text] : image.metadata) EXPECT_EQ(read.metadata.at(key), text);
  EXPECT_EQ(folder.entry_count(), 1u);
}

TEST(ExrFile, KeepsNaN) {
  const TemporaryFolder folder;
  ImageLayers image = some_image();
  image.channels["G"][2] = std::numeric_limits<float>::quiet_NaN();
  write_exr(folder / "a.exr", image);
  EXPECT_TRUE(std::isnan(read_exr(folder / "a.exr").channels.at("G")[2]));
}

// A window that does not begin at 0, half and uint channels, tiles.
TEST(ExrFile, ReadsTilesHalfAndUint) {
  const TemporaryFolder folder;
  const Imath::Box2i window({-3, 10}, {3, 14});
  Imf::Header header(Imath::Box2i({0, 0}, {9, 9}), window);
  header.channels().insert("H", Imf::Channel(Imf::HALF));
  header.channels().insert("U", Imf::Channel(Imf::UINT));
  header.setTileDescription(Imf::TileDescription(4, 4));
  std::vector<half> halves;
  std::vector<unsigned> uints;
  for (unsigned i = 0; i < 35; ++i) {
    halves.push_back(half(0.5f * static_cast<float>(i)));
    uints.push_back(1000 * i);
  }
  Imf::FrameBuffer frame;
  frame.insert("H",
               Imf::Slice::Make(Imf::HALF, halves.data(), window, sizeof(half), 7 * sizeof(half)));
  frame.insert("U", Imf::Slice::Make(Imf::UINT, uints.data(), window, sizeof(unsigned),
                                     7 * sizeof(unsigned)));
  {
    Imf::TiledOutputFile out((folder / "t.exr").c_str(), header);
    out.setFrameBuffer(frame);
    out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
  }
  const ImageLayers read = read_exr(folder / "t.exr");
  ASSERT_EQ(read.width, 7);
  ASSERT_EQ(read.height, 5);
  for (std::size_t i = 0; i < 35; ++i) {
    EXPECT_EQ(read.channels.at("H")[i], 0.5f * static_cast<float>(i));
    EXPECT_EQ(read.channels.at("U")[i], 1000.0f * static_cast<float>(i));
  }
}

TEST(ExrFile, RefusesDeepImages) {
  const TemporaryFolder folder;
  Imf::Header header(2, 2);
  header.channels().insert("R", Imf::Channel(Imf::FLOAT));
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  { const Imf::DeepScanLineOutputFile out((folder / "d.exr").c_str(), header); }
  EXPECT_TRUE(contains(error_of([&] { read_exr(folder / "d.exr"); }), "d.exr"));
}

TEST(ExrFile, EveryTruncationAndManyDamagesAreRefusedOrRead) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", some_image());
  const std::string whole = content_of(folder / "a.exr");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto file = folder.write("cut.exr", whole.substr(0, size));
    EXPECT_THROW(read_exr(file), InputError) << size << " bytes";
  }
  // A damaged byte may go unseen, but nothing other than an InputError may come of it.
  std::size_t refused = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
    const auto file = folder.write("damaged.exr", damaged);
    try {
      read_exr(file);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, whole.size() / 10);
}

TEST(ExrFile, RefusesAHugeImageInASmallFile) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", some_image());
  std::string bytes = content_of(folder / "a.exr");
  const std::size_t window = bytes.find(std::string("dataWindow\0box2i\0", 17)) + 17 + 4;
  const std::int32_t side = 30'000;
  bytes.replace(window + 8, 4, reinterpret_cast<const char*>(&side), 4);
  bytes.replace(window + 12, 4, reinterpret_cast<const char*>(&side), 4);
  const std::string error = error_of([&] { read_exr(folder.write("b.exr", bytes)); });
  EXPECT_TRUE(contains(error, "b.exr")) << error;
}

// In an image just small enough not to be refused for its size.
TEST(ExrFile, TakesNoMemoryForRowsThatAreNotThere) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", some_image());
  std::string bytes = content_of(folder / "a.exr");
  const std::size_t window = bytes.find(std::string("dataWindow\0box2i\0", 17)) + 17 + 4;
  const std::int32_t last = 8000;  // four channels of 8001 x 8001 pixels: 977 MiB
  bytes.replace(window + 8, 4, reinterpret_cast<const char*>(&last), 4);
  bytes.replace(window + 12, 4, reinterpret_cast<const char*>(&last), 4);
  const auto most_memory = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;  // [KiB]
  };
  const long before = most_memory();
  bytes += std::string(8000, '\1');  // enough for the table of where rows are
  EXPECT_THROW(read_exr(folder.write("b.exr", bytes)), InputError);
  EXPECT_LT(most_memory() - before, 100 * 1024);
}

TEST(ExrFile, KeepsTheOldFileWhenWritingFails) {
  const TemporaryFolder folder;
  folder.write("a.exr", "old");
  ImageLayers image = some_image();
  image.width = 0;  // OpenEXR refuses it
  image.channels.clear();
  EXPECT_THROW(write_exr(folder / "a.exr", image), InputError);
  EXPECT_EQ(content_of(folder / "a.exr"), "old");
  EXPECT_EQ(folder.entry_count(), 1u);
}

TEST(PngFile, HoldsThePixelsAndTheText) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> rgb;
  for (int i = 0; i < 4 * 3 * 3; ++i) rgb.push_back(static_cast<std::uint8_t>(7 * i));
  write_png(folder / "a.png", 4, 3, rgb, {{"scene", "sc\xc3\xa8ne"}, {"airlight", "paper"}});

  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&image, (folder / "a.png").c_str()), 0);
  EXPECT_EQ(image.width, 4u);
  EXPECT_EQ(image.height, 3u);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> read(rgb.size());
  ASSERT_NE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr), 0);
  EXPECT_EQ(read, rgb);
  const std::string bytes = content_of(folder / "a.png");
  EXPECT_TRUE(contains(bytes, "sRGB"));
  EXPECT_TRUE(contains(bytes, std::string("tEXtairlight\0paper", 18)));
  EXPECT_TRUE(contains(bytes, "sc\xc3\xa8ne"));
}

TEST(PngFile, KeepsTheOldFileWhenWritingFails) {
  const TemporaryFolder folder;
  folder.write("a.png", "old");
  EXPECT_THROW(write_png(folder / "a.png", 0, 3, {}, {}), InputError);  // libpng refuses it
  EXPECT_EQ(content_of(folder / "a.png"), "old");
  EXPECT_EQ(folder.entry_count(), 1u);
}

}  // namespace
}  // namespace brume
