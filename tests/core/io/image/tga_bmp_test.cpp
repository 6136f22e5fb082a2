#include <gtest/gtest.h>

#include "core/io/byte_reader.h"
#include "core/io/image/pixel_decoders.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

std::string text_of(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) text += static_cast<char>(byte);
  return text;
}

// The colors of three by two pixels, rows from the top.
const std::vector<Rgba> picture_colors{{255, 0, 0, 255}, {0, 255, 0, 255},     {0, 0, 255, 255},
                                       {0, 0, 0, 255},   {255, 255, 255, 255}, {255, 0, 255, 255}};
constexpr int picture_width = 3;
constexpr int picture_height = 2;

std::vector<Rgba> rows_of(Pixels pixels) {
  EXPECT_EQ(pixels.width, picture_width);
  EXPECT_EQ(pixels.height, picture_height);
  std::vector<Rgba> result;
  for (std::size_t i = 0; i < pixels.rgba.size(); ++i) {
    const std::uint8_t* pixel = pixels.row(0) + 4 * i;
    result.push_back({pixel[0], pixel[1], pixel[2], pixel[3]});
  }
  return result;
}

// The bytes of a color in files of both formats.
std::string color_bytes(const Rgba& color, int bits) {
  if (bits == 16) {
    std::string bytes;
    append_little_endian(bytes, static_cast<std::uint16_t>((color[0] >> 3) << 10 |
                                                           (color[1] >> 3) << 5 | color[2] >> 3));
    return bytes;
  }
  std::string bytes = text_of({color[2], color[1], color[0]});
  if (bits == 32) bytes += text_of({color[3]});
  return bytes;
}

struct TgaKind {
  int type = 2;
  int bits = 24;
  int palette_count = 0;
  int descriptor = 0;
};

std::string tga_header(const TgaKind& kind) {
  return text_of({3, kind.palette_count > 0 ? 1 : 0, kind.type, 0, 0, kind.palette_count, 0,
                  kind.palette_count > 0 ? 24 : 0, 0, 0, 0, 0, picture_width, 0, picture_height, 0,
                  kind.bits, kind.descriptor}) +
         "own";  // the text that the first byte announces
}

// The pixel that a TGA has at position `i`, in the order that its descriptor says.
std::size_t place_of(std::size_t i, int descriptor) {
  const std::size_t x =
      (descriptor & 0x10) != 0 ? picture_width - 1 - i % picture_width : i % picture_width;
  const std::size_t y =
      (descriptor & 0x20) != 0 ? i / picture_width : picture_height - 1 - i / picture_width;
  return y * picture_width + x;
}

TEST(TgaDecoder, ReadsColorsFromEveryOrigin) {
  for (const int descriptor : {0, 0x10, 0x20, 0x30}) {
    for (const int bits : {15, 16, 24, 32}) {
      SCOPED_TRACE(testing::Message() << bits << " bits, descriptor " << descriptor);
      std::string bytes = tga_header({2, bits, 0, descriptor});
      for (std::size_t i = 0; i < picture_colors.size(); ++i) {
        bytes += color_bytes(picture_colors[place_of(i, descriptor)], bits == 15 ? 16 : bits);
      }
      ASSERT_TRUE(is_tga(bytes));
      EXPECT_EQ(rows_of(decode_tga("a.tga", bytes)), picture_colors);
    }
  }
}

TEST(TgaDecoder, ReadsPalettesAndGrays) {
  std::string indexed = tga_header({1, 8, 6, 0x20});
  for (const Rgba& color : picture_colors) indexed += color_bytes(color, 24);
  const std::string entries = text_of({0, 1, 2, 3, 4, 5});
  EXPECT_EQ(rows_of(decode_tga("a.tga", indexed + entries)), picture_colors);
  const Pixels gray = decode_tga("a.tga", tga_header({3, 8, 0, 0x20}) + "abcdef");
  EXPECT_EQ(rows_of(gray)[4], (Rgba{'e', 'e', 'e', 255}));
}

TEST(TgaDecoder, ReadsRunsThatCrossRows) {
  std::string bytes = tga_header({10, 24, 0, 0x20});
  const Rgba red{255, 0, 0, 255};
  const Rgba blue{0, 0, 255, 255};
  bytes += text_of({0x80 | 3}) + color_bytes(red, 24);  // four times
  bytes +=
      text_of({1}) + color_bytes(blue, 24) + color_bytes(picture_colors[5], 24);  // two as they are
  EXPECT_EQ(rows_of(decode_tga("a.tga", bytes)),
            (std::vector<Rgba>{red, red, red, red, blue, picture_colors[5]}));
  EXPECT_EQ(rows_of(decode_tga("a.tga", tga_header({11, 8, 0, 0x20}) + text_of({0x85, 7}))),
            std::vector<Rgba>(6, Rgba{7, 7, 7, 255}));
}

TEST(TgaDecoder, HasAlphaWhereTheHeaderSaysSo) {
  std::string bytes = tga_header({2, 32, 0, 0x28});
  for (int i = 0; i < 6; ++i) bytes += text_of({1, 2, 3, 40});
  EXPECT_EQ(rows_of(decode_tga("a.tga", bytes))[0], (Rgba{3, 2, 1, 40}));
  bytes[17] = 0x20;
  EXPECT_EQ(rows_of(decode_tga("a.tga", bytes))[0], (Rgba{3, 2, 1, 255}));
}

// The rows of a BMP: of whole words, the last one first.
std::string bmp_rows(int bits) {
  std::string bytes;
  for (std::size_t y = picture_height; y-- > 0;) {
    std::string row;
    for (std::size_t x = 0; x < picture_width; ++x)
      row += color_bytes(picture_colors[y * picture_width + x], bits);
    row.resize((row.size() + 3) / 4 * 4);
    bytes += row;
  }
  return bytes;
}

std::string bmp(std::uint16_t bits, std::uint32_t compression, const std::string& palette,
                const std::string& data, std::int32_t rows = picture_height) {
  std::string bytes = "BM" + std::string(8, '\0');
  append_little_endian(bytes, static_cast<std::uint32_t>(54 + palette.size()));
  append_little_endian(bytes, std::uint32_t{40});
  append_little_endian(bytes, std::int32_t{picture_width});
  append_little_endian(bytes, rows);
  append_little_endian(bytes, std::uint16_t{1});
  append_little_endian(bytes, bits);
  append_little_endian(bytes, compression);
  bytes += std::string(20, '\0');
  return bytes + palette + data;
}

std::string bmp_palette() {
  std::string palette;
  for (const Rgba& color : picture_colors) palette += color_bytes(color, 24) + '\0';
  return palette;
}

TEST(BmpDecoder, ReadsColors) {
  for (const std::uint16_t bits : {16, 24, 32}) {
    const std::string bytes = bmp(bits, 0, "", bmp_rows(bits));
    ASSERT_TRUE(is_bmp(bytes));
    EXPECT_EQ(rows_of(decode_bmp("a.bmp", bytes)), picture_colors) << bits;
  }
  const std::vector<Rgba> turned{picture_colors[3], picture_colors[4], picture_colors[5],
                                 picture_colors[0], picture_colors[1], picture_colors[2]};
  EXPECT_EQ(rows_of(decode_bmp("a.bmp", bmp(24, 0, "", bmp_rows(24), -picture_height))), turned);
}

TEST(BmpDecoder, ReadsBitFields) {
  std::string masks;
  for (const std::uint32_t mask : {0x0000ffu, 0x00ff00u, 0xff0000u}) {
    append_little_endian(masks, mask);
  }
  std::string data;
  for (const std::size_t i : {3u, 4u, 5u, 0u, 1u, 2u}) {
    data += text_of({picture_colors[i][0], picture_colors[i][1], picture_colors[i][2], 0});
  }
  EXPECT_EQ(rows_of(decode_bmp("a.bmp", bmp(32, 3, masks, data))), picture_colors);
}

TEST(BmpDecoder, ReadsPalettes) {
  const std::string palette = bmp_palette();
  const std::string eight = text_of({3, 4, 5, 0, 0, 1, 2, 0});
  EXPECT_EQ(rows_of(decode_bmp("a.bmp", bmp(8, 0, palette, eight))), picture_colors);
  const std::string four = text_of({0x34, 0x50, 0, 0, 0x01, 0x20, 0, 0});
  EXPECT_EQ(rows_of(decode_bmp("a.bmp", bmp(4, 0, palette, four))), picture_colors);
  const std::string one = text_of({0x40, 0, 0, 0, 0xa0, 0, 0, 0});
  EXPECT_EQ(rows_of(decode_bmp("a.bmp", bmp(1, 0, palette.substr(0, 8), one))),
            (std::vector<Rgba>{picture_colors[1], picture_colors[0], picture_colors[1],
                               picture_colors[0], picture_colors[1], picture_colors[0]}));
}

TEST(BmpDecoder, ReadsRuns) {
  const std::string palette = bmp_palette();
  // Values by themselves, the end of the row, a run and one more, the end.
  const std::string eight = text_of({0, 3, 3, 4, 5, 0, 0, 0, 2, 1, 1, 2, 0, 1});
  EXPECT_EQ(rows_of(decode_bmp("a.bmp", bmp(8, 1, palette, eight))),
            (std::vector<Rgba>{picture_colors[1], picture_colors[1], picture_colors[2],
                               picture_colors[3], picture_colors[4], picture_colors[5]}));
  const std::string four = text_of({3, 0x45, 0, 0, 0, 3, 0x12, 0x30, 0, 1});
  EXPECT_EQ(rows_of(decode_bmp("a.bmp", bmp(4, 2, palette, four))),
            (std::vector<Rgba>{picture_colors[1], picture_colors[2], picture_colors[3],
                               picture_colors[4], picture_colors[5], picture_colors[4]}));
}

std::vector<std::pair<Pixels (*)(const std::filesystem::path&, std::string_view), std::string>>
whole_files() {
  std::string tga = tga_header({2, 24, 0, 0});
  for (const Rgba& color : picture_colors) tga += color_bytes(color, 24);
  std::string indexed = tga_header({1, 8, 6, 0x20});
  for (const Rgba& color : picture_colors) indexed += color_bytes(color, 24);
  return {{decode_tga, tga},
          {decode_tga, indexed + text_of({0, 1, 2, 3, 4, 5})},
          {decode_tga, tga_header({11, 8, 0, 0x20}) + text_of({0x85, 7})},
          {decode_bmp, bmp(24, 0, "", bmp_rows(24))},
          {decode_bmp, bmp(8, 0, bmp_palette(), text_of({3, 4, 5, 0, 0, 1, 2, 0}))},
          {decode_bmp, bmp(8, 1, bmp_palette(), text_of({6, 1, 0, 0, 6, 2, 0, 1}))}};
}

// The bytes that pad the last row of a BMP may be missing.
TEST(PixelDecoders, TruncatedAnywhereIsRefused) {
  for (const auto& [decode, whole] : whole_files()) {
    EXPECT_NO_THROW(decode("a", whole));
    expect_truncations_refused(
        whole, [&](const std::string& bytes) { decode("a", bytes); }, 1, 4);
  }
}

TEST(PixelDecoders, DamageIsAPictureOrAnError) {
  for (const auto& [decode, whole] : whole_files()) {
    for (const int change : {0x01, 0x55, 0x80, 0xff}) {
      refused_damages(
          whole, [&](const std::string& bytes) { decode("a", bytes); }, change);
    }
  }
}

TEST(PixelDecoders, SizesAreCheckedBeforeTheirMemory) {
  std::string tga = tga_header({2, 24, 0, 0}) + std::string(64, '\0');
  tga[13] = tga[15] = 0x40;  // 16387 x 16386
  expect_error([&] { decode_tga("a.tga", tga); }, "allowed: 1 to 16384 a side");
  tga[13] = tga[15] = 0x3f;
  expect_error([&] { decode_tga("a.tga", tga); }, "more pixels than a file");
  std::string runs = bmp(8, 1, bmp_palette(), text_of({0, 1}));
  runs[19] = runs[23] = 0x3f;
  expect_error([&] { decode_bmp("a.bmp", runs); }, "more pixels than a file");
}

}  // namespace
}  // namespace brume
