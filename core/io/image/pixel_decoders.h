#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "brume/limits.h"

namespace brume {

// RGBA of 8 bits each, rows from the top, as they are in the file: nothing is made linear.
struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

// Each takes the bytes of a file (the name is for errors). Palettes, grays and 16 bits become 8-bit
// RGBA; color profiles are left out, as glTF asks. Throws InputError: damaged, cut short, more than
// limits::texture_side pixels a side.
Pixels decode_png(const std::filesystem::path& file, std::string_view bytes);
Pixels decode_jpeg(const std::filesystem::path& file, std::string_view bytes);  // gray or color

bool is_png(std::string_view bytes);
bool is_jpeg(std::string_view bytes);

// Throws InputError where there are more pixels a side.
void check_texture_size(const std::filesystem::path& file, std::uint64_t width,
                        std::uint64_t height);

}  // namespace brume
