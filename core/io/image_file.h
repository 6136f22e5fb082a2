#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace brume {

// An image of named float channels ("R", "airlight.G", "Z"), each width * height values, rows
// from the top, plus text metadata.
struct ImageLayers {
  int width = 0;
  int height = 0;
  std::map<std::string, std::vector<float>> channels;
  std::map<std::string, std::string> metadata;
};

// OpenEXR, 32-bit float scan lines, ZIP. Reading converts half and uint channels to float.
// Both throw InputError; an existing file is replaced only by a complete one.
ImageLayers read_exr(const std::filesystem::path& file);
void write_exr(const std::filesystem::path& file, const ImageLayers& image);

// 8-bit sRGB PNG from width * height * 3 bytes; metadata goes into text chunks.
void write_png(const std::filesystem::path& file, int width, int height,
               std::span<const std::uint8_t> rgb,
               const std::map<std::string, std::string>& metadata);

}  // namespace brume
