#include "core/io/image/image_file.h"

#include <ImfChannelList.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>
#include <half.h>
#include <png.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"

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

using ExrFile = FolderTest;

TEST_F(ExrFile, ReadsBackExactlyWhatWasWritten) {
  const ImageLayers image = some_image();
  write_exr(folder_ / "a.exr", image);
  const ImageLayers read = read_exr(folder_ / "a.exr");
  EXPECT_EQ(read.width, 5);
  EXPECT_EQ(read.height, 3);
  EXPECT_EQ(read.channels, image.channels);
  for (const auto& [key, text] : image.metadata) EXPECT_EQ(read.metadata.at(key), text);
  EXPECT_EQ(folder_.entry_count(), 1u);
}

TEST_F(ExrFile, TellsItsChromaticities) {
  write_exr(folder_ / "a.exr", some_image());
  const Imf::InputFile file((folder_ / "a.exr").c_str());
  ASSERT_TRUE(Imf::hasChromaticities(file.header()));
  EXPECT_EQ(Imf::chromaticities(file.header()), Imf::Chromaticities());  // Rec. 709
}

TEST_F(ExrFile, PreservesNaN) {
  ImageLayers image = some_image();
  image.channels["G"][2] = std::numeric_limits<float>::quiet_NaN();
  write_exr(folder_ / "a.exr", image);
  EXPECT_TRUE(std::isnan(read_exr(folder_ / "a.exr").channels.at("G")[2]));
}

// A window that does not begin at 0, half and uint channels, tiles.
TEST_F(ExrFile, ReadsTilesHalfAndUint) {
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
    Imf::TiledOutputFile out((folder_ / "t.exr").c_str(), header);
    out.setFrameBuffer(frame);
    out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
  }
  const ImageLayers read = read_exr(folder_ / "t.exr");
  ASSERT_EQ(read.width, 7);
  ASSERT_EQ(read.height, 5);
  for (std::size_t i = 0; i < 35; ++i) {
    EXPECT_EQ(read.channels.at("H")[i], 0.5f * static_cast<float>(i));
    EXPECT_EQ(read.channels.at("U")[i], 1000.0f * static_cast<float>(i));
  }
}

TEST_F(ExrFile, RefusesDeepImages) {
  Imf::Header header(2, 2);
  header.channels().insert("R", Imf::Channel(Imf::FLOAT));
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  { const Imf::DeepScanLineOutputFile out((folder_ / "d.exr").c_str(), header); }
  expect_error([&] { read_exr(folder_ / "d.exr"); }, "d.exr");
}

TEST_F(ExrFile, EveryTruncationAndManyDamagesAreRefusedOrRead) {
  write_exr(folder_ / "a.exr", some_image());
  const std::string complete = content_of(folder_ / "a.exr");
  const auto read = [&](const std::string& bytes) { read_exr(folder_.write("b.exr", bytes)); };
  expect_truncations_refused(complete, read);
  EXPECT_GT(refused_damages(complete, read), complete.size() / 10);
}

TEST_F(ExrFile, RefusesAHugeImageInASmallFile) {
  write_exr(folder_ / "a.exr", some_image());
  std::string bytes = content_of(folder_ / "a.exr");
  const std::size_t window = bytes.find(std::string("dataWindow\0box2i\0", 17)) + 17 + 4;
  const std::int32_t side = 30'000;
  bytes.replace(window + 8, 4, reinterpret_cast<const char*>(&side), 4);
  bytes.replace(window + 12, 4, reinterpret_cast<const char*>(&side), 4);
  expect_error([&] { read_exr(folder_.write("b.exr", bytes)); }, "b.exr");
}

long max_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;  // [KiB]
}

void put(std::string& bytes, std::size_t offset, std::int32_t value) {
  bytes.replace(offset, sizeof(value), reinterpret_cast<const char*>(&value), sizeof(value));
}

// Where the value of an attribute begins.
std::size_t value_of(const std::string& bytes, const std::string& name, const std::string& type) {
  const std::string head = name + '\0' + type + '\0';
  return bytes.find(head) + head.size() + sizeof(std::int32_t);
}

// Each was taken before the file was read on: 2 GB.
TEST_F(ExrFile, AllocatesNothingForMissingAttributes) {
  write_exr(folder_ / "a.exr", some_image());
  std::string bytes = content_of(folder_ / "a.exr");
  put(bytes, value_of(bytes, "scene", "string") - sizeof(std::int32_t), 0x7ffffff0);
  const long before = max_memory();
  expect_error([&] { read_exr(folder_.write("b.exr", bytes)); },
               "attribute scene: claims 2147483632 bytes");
  EXPECT_LT(max_memory() - before, 100 * 1024);
}

// The last row of tiles is there, the 249 before it are not: a gigabyte of zeros compressed.
TEST_F(ExrFile, AllocatesNothingForMissingTiles) {
  constexpr int width = 16'000;
  constexpr int rows = 250;  // of tiles
  const std::vector<float> zeros(std::size_t{width} * 64);
  Imf::Header header(width, 64);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.channels().insert("R", Imf::Channel(Imf::FLOAT));
  header.setTileDescription(Imf::TileDescription(width, 64));
  Imf::FrameBuffer frame;
  frame.insert("R", Imf::Slice::Make(Imf::FLOAT, zeros.data(), header.dataWindow(), sizeof(float),
                                     width * sizeof(float)));
  {
    Imf::TiledOutputFile out((folder_ / "t.exr").c_str(), header);
    out.setFrameBuffer(frame);
    out.writeTile(0, 0);
  }
  std::string bytes = content_of(folder_ / "t.exr");
  std::uint64_t tile = 0;  // where it begins: the one entry of the table before it
  std::size_t table = bytes.size() - sizeof(tile);
  for (; table > 0 && tile != table + sizeof(tile); --table) {
    std::memcpy(&tile, bytes.data() + table - 1, sizeof(tile));
  }
  const std::uint64_t moved = tile + (rows - 1) * sizeof(tile);
  std::string entries;
  for (int row = 0; row < rows; ++row) {
    entries.append(reinterpret_cast<const char*>(&moved), sizeof(moved));
  }
  bytes.replace(table, sizeof(tile), entries);
  put(bytes, static_cast<std::size_t>(moved) + 4, rows - 1);  // the tile's y
  put(bytes, value_of(bytes, "dataWindow", "box2i") + 12, 64 * rows - 1);
  const long before = max_memory();
  expect_error([&] { read_exr(folder_.write("b.exr", bytes)); },
               "16000 x 16000 pixels of 1 channel; the file is too short");
  EXPECT_LT(max_memory() - before, 100 * 1024);
}

TEST_F(ExrFile, RefusesTilesMuchLargerThanTheImage) {
  Imf::Header header(8, 8);
  header.channels().insert("R", Imf::Channel(Imf::FLOAT));
  header.setTileDescription(Imf::TileDescription(16, 16));
  const std::vector<float> values(64, 0.5f);
  Imf::FrameBuffer frame;
  frame.insert("R", Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow(), sizeof(float),
                                     8 * sizeof(float)));
  {
    Imf::TiledOutputFile out((folder_ / "t.exr").c_str(), header);
    out.setFrameBuffer(frame);
    out.writeTile(0, 0);
  }
  EXPECT_EQ(read_exr(folder_ / "t.exr").channels.at("R"), values);
  std::string bytes = content_of(folder_ / "t.exr");
  const std::size_t tiles = value_of(bytes, "tiles", "tiledesc");
  put(bytes, tiles, 20'000);
  put(bytes, tiles + 4, 20'000);
  expect_error([&] { read_exr(folder_.write("b.exr", bytes)); },
               "blocks of 20000 x 20000 pixels in an image of 8 x 8");
}

// The best compressed image of each kind is still read: one colour in half precision.
TEST_F(ExrFile, ReadsWhatCompressesBest) {
  constexpr int side = 1024;
  const std::vector<half> values(std::size_t{side} * side, half(0.5f));
  for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression) {
    SCOPED_TRACE(compression);
    Imf::Header header(side, side);
    header.compression() = static_cast<Imf::Compression>(compression);
    Imf::FrameBuffer frame;
    for (const char* name : {"R", "G", "B"}) {
      header.channels().insert(name, Imf::Channel(Imf::HALF));
      frame.insert(name, Imf::Slice::Make(Imf::HALF, values.data(), header.dataWindow(),
                                          sizeof(half), side * sizeof(half)));
    }
    {
      Imf::OutputFile out((folder_ / "c.exr").c_str(), header);
      out.setFrameBuffer(frame);
      out.writePixels(side);
    }
    // DWA is lossy.
    EXPECT_NEAR(read_exr(folder_ / "c.exr").channels.at("G").back(), 0.5f, 1e-3f);
  }
}

TEST(PngFile, StoresPixelsAndText) {
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
  EXPECT_TRUE(contains(bytes, "sRGB", std::string("tEXtairlight\0paper", 18), "sc\xc3\xa8ne"));
}

TEST(PngFile, StoresSixteenBits) {
  const TemporaryFolder folder;
  std::vector<std::uint16_t> rgb;
  std::vector<std::uint8_t> high_bytes;
  for (int i = 0; i < 4 * 3 * 3; ++i) {
    high_bytes.push_back(static_cast<std::uint8_t>(3 * i));
    rgb.push_back(static_cast<std::uint16_t>(256 * 3 * i + 16));
  }
  write_png(folder / "a.png", 4, 3, rgb, {});
  EXPECT_EQ(content_of(folder / "a.png")[24], 16);  // bits of a value, in the header

  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&image, (folder / "a.png").c_str()), 0);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> read(rgb.size());
  ASSERT_NE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr), 0);
  EXPECT_EQ(read, high_bytes);
}

}  // namespace
}  // namespace brume
