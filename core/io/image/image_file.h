#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "brume/image_layers.h"
#include "brume/limits.h"

namespace brume {

// How a rendered picture sees its scene: standard attributes of OpenEXR.
struct ExrView {
  // worldToCamera: x to the right, y up, z along the view [u].
  glm::dmat4 world_to_camera{1.0};
  // worldToNDC: x and y from (0, 0), the upper left corner of the picture, to (1, 1).
  glm::dmat4 world_to_ndc{1.0};
  double frames_per_second = 0.0;  // 0: not known
};

// OpenEXR. Reads the first flat part, scan lines or tiles, of a file; half and uint channels
// become float, values that are not finite stay. Throws InputError: no EXR, truncated, deep only,
// subsampled, larger than limits::image_side a side.
ImageLayers read_exr(const std::filesystem::path& file);

// Writes 32-bit float scan lines, ZIP; an existing file is replaced only by a complete one. Throws
// InputError. Every channel must have width * height values (assert).
void write_exr(const std::filesystem::path& file, const ImageLayers& image,
               const std::optional<ExrView>& view = {});

// How many threads compress rows of EXR files, in the whole program; at first the caller's alone.
void set_image_threads(int threads);

// The text attributes of the first part, flat or deep, of a complete file. Throws InputError, also
// where a file is incomplete.
std::map<std::string, std::string> read_exr_texts(const std::filesystem::path& file);
// The texts in plain chunks of a complete PNG. Throws InputError.
std::map<std::string, std::string> read_png_texts(const std::filesystem::path& file);

// Whether the file begins as an OpenEXR file does. Throws InputError where it cannot be read.
bool is_exr(const std::filesystem::path& file);

// sRGB PNG of 8 or 16 bits, from width * height * 3 values, rows from the top; metadata goes into
// text chunks. An existing file is replaced only by a complete one. Throws InputError.
void write_png(const std::filesystem::path& file, int width, int height,
               std::span<const std::uint8_t> rgb,
               const std::map<std::string, std::string>& metadata);
void write_png(const std::filesystem::path& file, int width, int height,
               std::span<const std::uint16_t> rgb,
               const std::map<std::string, std::string>& metadata);
// The same of width * height * 4 values of 8 bits, with alpha, without metadata.
void write_png_with_alpha(const std::filesystem::path& file, int width, int height,
                          std::span<const std::uint8_t> rgba);

// The bytes of such a file, of 8 bits.
std::string encode_png(int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace brume
