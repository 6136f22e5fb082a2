#include "core/io/image/texture_file.h"

#include <utility>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/image/image_file.h"
#include "core/io/image/image_kind.h"
#include "core/io/image/pixel_decoders.h"
#include "core/io/image/radiance_map_file.h"

namespace brume {
namespace {

std::shared_ptr<const Texture> read_radiance(const std::filesystem::path& file,
                                             std::vector<std::string>* warnings) {
  const auto map = read_radiance_map(file, warnings);
  check_texture_size(file, static_cast<std::uint64_t>(map->width),
                     static_cast<std::uint64_t>(map->height));
  return std::make_shared<const Texture>(map->width, map->height, map->pixels);
}

}  // namespace

Pixels::Pixels(int image_width, int image_height) : width(image_width), height(image_height) {
  rgba.reserve(Texture::texel_count(width, height));
  rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

std::shared_ptr<const Texture> decode_texture(const std::filesystem::path& file,
                                              std::string_view bytes, bool has_colors) {
  const auto decode = is_png(bytes)    ? decode_png
                      : is_jpeg(bytes) ? decode_jpeg
                      : is_bmp(bytes)  ? decode_bmp
                      : is_tga(bytes)  ? decode_tga
                                       : nullptr;
  if (decode == nullptr) {
    throw InputError(file, "header",
                     "found " + image_kind(bytes) + "; allowed: PNG, JPEG, TGA or BMP" +
                         (has_colors ? ", of colors also OpenEXR and Radiance HDR" : ""));
  }
  Pixels pixels = decode(file, bytes);
  return std::make_shared<const Texture>(
      pixels.width, pixels.height, std::move(pixels.rgba),
      has_colors ? Texture::Encoding::srgb : Texture::Encoding::linear);
}

std::shared_ptr<const Texture> read_texture(const std::filesystem::path& file, bool has_colors,
                                            std::vector<std::string>* warnings) {
  if (has_colors && (is_exr(file) || read_first_bytes(file, 2) == "#?")) {
    return read_radiance(file, warnings);
  }
  return decode_texture(file, read_bytes(file), has_colors);
}

}  // namespace brume
