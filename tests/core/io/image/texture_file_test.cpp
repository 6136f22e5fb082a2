#include "core/io/image/texture_file.h"

#include <gtest/gtest.h>
// libjpeg's headers need <cstdio> before them.
#include <jpeglib.h>

#include <cstdlib>

#include "brume/limits.h"
#include "core/io/image/image_file.h"
#include "core/io/image/pixel_decoders.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

// A ramp of 16 x 8 pixels, red to the right and green down.
constexpr int width = 16;
constexpr int height = 8;
std::vector<std::uint8_t> ramp() {
  std::vector<std::uint8_t> rgb;
  for (int i = 0; i < width * height; ++i) {
    rgb.push_back(static_cast<std::uint8_t>(i % width * 16));
    rgb.push_back(static_cast<std::uint8_t>(i / width * 32));
    rgb.push_back(100);
  }
  return rgb;
}

std::string png() {
  return encode_png(width, height, ramp());
}

// A JPEG of pixels of 3 or 4 components.
std::string jpeg(std::vector<std::uint8_t> pixels, J_COLOR_SPACE space, int components) {
  jpeg_compress_struct encoder{};
  jpeg_error_mgr errors{};
  encoder.err = jpeg_std_error(&errors);
  jpeg_create_compress(&encoder);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&encoder, &bytes, &size);
  encoder.image_width = width;
  encoder.image_height = height;
  encoder.input_components = components;
  encoder.in_color_space = space;
  jpeg_set_defaults(&encoder);
  jpeg_set_quality(&encoder, 98, TRUE);
  jpeg_start_compress(&encoder, TRUE);
  while (encoder.next_scanline < encoder.image_height) {
    const std::size_t row_bytes = pixels.size() / height;
    JSAMPROW row = pixels.data() + row_bytes * encoder.next_scanline;
    jpeg_write_scanlines(&encoder, &row, 1);
  }
  jpeg_finish_compress(&encoder);
  std::string result(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&encoder);
  std::free(bytes);
  return result;
}

std::string jpeg() {
  return jpeg(ramp(), JCS_RGB, 3);
}

TEST(TextureFile, ReadsPngExactly) {
  Pixels pixels = decode_png("a.png", png());
  ASSERT_EQ(pixels.width, width);
  ASSERT_EQ(pixels.height, height);
  const std::vector<std::uint8_t> rgb = ramp();
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    EXPECT_EQ(pixels.row(0)[i / 3 * 4 + i % 3], rgb[i]);
  }
  EXPECT_EQ(pixels.row(0)[3], 255);
}

TEST(TextureFile, ReadsJpeg) {
  Pixels pixels = decode_jpeg("a.jpg", jpeg());
  ASSERT_EQ(pixels.width, width);
  ASSERT_EQ(pixels.height, height);
  EXPECT_NEAR(pixels.row(0)[4 * 8], 128, 12);
  EXPECT_NEAR(pixels.row(7)[1], 224, 12);
}

// libjpeg marks them as Adobe's: 255 is no ink.
TEST(TextureFile, ReadsJpegOfInks) {
  std::vector<std::uint8_t> inks;
  for (int i = 0; i < width * height; ++i) inks.insert(inks.end(), {255, 0, 128, 200});
  Pixels pixels = decode_jpeg("a.jpg", jpeg(inks, JCS_CMYK, 4));
  const std::uint8_t* pixel = pixels.row(0);
  EXPECT_NEAR(pixel[0], 200, 6);
  EXPECT_NEAR(pixel[1], 0, 6);
  EXPECT_NEAR(pixel[2], 100, 6);
  EXPECT_EQ(pixel[3], 255);
}

TEST(TextureFile, NamesWhatItFound) {
  using namespace std::string_view_literals;
  for (const auto& [bytes, kind] : std::vector<std::pair<std::string_view, const char*>>{
           {"version https://git-lfs.github.com/spec/v1\noid sha256:0"sv, "a Git LFS pointer"},
           {"RIFF\x10\0\0\0WEBPVP8 "sv, "a WebP image"},
           {"II*\0\x08\0\0\0"sv, "a TIFF image"},
           {"MM\0*"sv, "a TIFF image"},
           {"DDS |"sv, "a DDS image"},
           {"\0\0\0\x1c"
            "ftypavif"sv,
            "an AVIF or HEIF image"},
           {"<!DOCTYPE html>"sv, "text, such as a web page"},
           {"abc"sv, "no image of a known kind"},
           {""sv, "an empty file"}}) {
    expect_error([&] { decode_texture("a.tga", bytes, true); },
                 {std::string("found ") + kind, "allowed: PNG, JPEG, TGA or BMP"});
  }
}

TEST(TextureFile, TellsColorsFromOtherValues) {
  const TemporaryFolder folder;
  // The name does not matter.
  const auto file = folder.write("a.bin", png());
  EXPECT_EQ(read_texture(file, true)->encoding(), Texture::Encoding::srgb);
  EXPECT_EQ(read_texture(file, false)->encoding(), Texture::Encoding::linear);
  ImageLayers sky;
  sky.width = sky.height = 1;
  for (const char* name : {"R", "G", "B"}) sky.channels[name] = {7.0f};
  write_exr(folder / "a.exr", sky);
  EXPECT_EQ(read_texture(folder / "a.exr", true)->average().r, 7.0f);
  expect_error([&] { read_texture(folder / "a.exr", false); },
               "found an OpenEXR image; allowed: PNG, JPEG, TGA or BMP");
}

TEST(TextureFile, RefusesDamagedFiles) {
  for (const std::string& whole : {png(), jpeg()}) {
    for (std::size_t length = 0; length < whole.size(); length += 1 + length / 8) {
      EXPECT_NE(error_of([&] { decode_texture("a", whole.substr(0, length), true); }), "")
          << length;
    }
    std::string damaged = whole;
    for (std::size_t i = 20; i < damaged.size(); i += 37)
      damaged[i] = static_cast<char>(~damaged[i]);
    try {
      decode_texture("a", damaged, true);  // JPEG may show something else
    } catch (const InputError&) {
    }
  }
}

TEST(TextureFile, RefusesSizesBeforeItsMemory) {
  std::string large = png();
  const auto set_side = [&](std::size_t at, unsigned side) {
    for (int i = 0; i < 4; ++i)
      large[at + static_cast<std::size_t>(i)] = static_cast<char>(side >> (24 - 8 * i));
  };
  // libpng warns of the header's checksum, then uses what it says.
  set_side(16, limits::texture_side + 1);
  const std::string message = error_of([&] { decode_texture("a.png", large, true); });
  EXPECT_TRUE(contains(message, "a.png") &&
              (contains(message, "allowed: 1 to 16384 a side") || contains(message, "CRC")));
  set_side(16, limits::texture_side);
  set_side(20, limits::texture_side);
  EXPECT_NE(error_of([&] { decode_texture("a.png", large, true); }), "");

  std::string wide = jpeg();
  const std::size_t header = wide.find("\xff\xc0");
  ASSERT_NE(header, std::string::npos);
  wide[header + 7] = '\x70';  // 28688 pixels
  expect_error([&] { decode_texture("a.jpg", wide, true); }, "allowed: 1 to 16384 a side");
  for (const std::size_t side : {header + 5, header + 7}) wide[side] = '\x30';  // 12304 at least
  expect_error([&] { decode_texture("a.jpg", wide, true); },
               "declares more pixels than a file of this length holds");
}

TEST(TextureFile, LevelsAreMadeInTheMemoryOfThePixels) {
  for (const bool is_jpeg : {false, true}) {
    Pixels pixels = is_jpeg ? decode_jpeg("a.jpg", jpeg()) : decode_png("a.png", png());
    const std::uint32_t* memory = pixels.rgba.data();
    const Texture texture(width, height, std::move(pixels.rgba), Texture::Encoding::srgb);
    EXPECT_EQ(texture.texels().data(), memory);
    EXPECT_EQ(texture.texels().size(), Texture::texel_count(width, height));
  }
}

}  // namespace
}  // namespace brume
