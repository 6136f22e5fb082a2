#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "brume/limits.h"

namespace brume {

using Rgba = std::array<std::uint8_t, 4>;

// RGBA of 8 bits each, rows from the top, as they are in the file: nothing is made linear.
struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> rgba;  // with room for the smaller levels of a texture

  Pixels() = default;
  Pixels(int image_width, int image_height);

  // The bytes of a row: R, G, B, A per pixel.
  [[nodiscard]] std::uint8_t* row(std::size_t y) {
    return reinterpret_cast<std::uint8_t*>(rgba.data() + y * static_cast<std::size_t>(width));
  }
  void set(std::size_t x, std::size_t y, const Rgba& pixel) {
    std::ranges::copy(pixel, row(y) + 4 * x);
  }
};

// Each takes the bytes of a file (the name is for errors). Palettes, grays and 16 bits become 8-bit
// RGBA; color profiles are left out, as glTF asks. Throws InputError: damaged, cut short, more than
// limits::texture_side pixels a side.
Pixels decode_png(const std::filesystem::path& file, std::string_view bytes);
// Gray, color or CMYK, without profiles.
Pixels decode_jpeg(const std::filesystem::path& file, std::string_view bytes);
// Gray, color or a palette, plain or run-length encoded.
Pixels decode_tga(const std::filesystem::path& file, std::string_view bytes);
// Windows' and OS/2's, of 1 to 32 bits, plain or run-length encoded.
Pixels decode_bmp(const std::filesystem::path& file, std::string_view bytes);

bool is_png(std::string_view bytes);
bool is_jpeg(std::string_view bytes);
bool is_tga(std::string_view bytes);  // by its header's plausibility: TGA has no signature
bool is_bmp(std::string_view bytes);

// Throws InputError where there are more pixels a side.
void check_texture_size(const std::filesystem::path& file, std::uint64_t width,
                        std::uint64_t height);

}  // namespace brume
