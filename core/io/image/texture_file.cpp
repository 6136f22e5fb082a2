#include "core/io/image/texture_file.h"

#include <array>
#include <utility>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/image/image_file.h"
#include "core/io/image/pixel_decoders.h"
#include "core/io/image/radiance_map_file.h"

namespace brume {
namespace {

// The kind of a file's bytes, in words, where an image that is read was expected: "a WebP image",
// "a Git LFS pointer ...".
std::string image_kind(std::string_view bytes) {
  using namespace std::string_view_literals;
  static constexpr std::array<std::pair<std::string_view, const char*>, 20> beginnings{{
      {"version https://git-lfs"sv,
       "a Git LFS pointer, not the image itself (git lfs pull gets it)"},
      {"\x89PNG\r\n\x1a\n"sv, "a PNG image"},
      {"\xff\xd8\xff"sv, "a JPEG image"},
      {"\x76\x2f\x31\x01"sv, "an OpenEXR image"},
      {"#?"sv, "a Radiance HDR image"},
      {"BM"sv, "a BMP image"},
      {"II*\0"sv, "a TIFF image"},
      {"MM\0*"sv, "a TIFF image"},
      {"II+\0"sv, "a TIFF image"},
      {"MM\0+"sv, "a TIFF image"},
      {"GIF8"sv, "a GIF image"},
      {"DDS "sv, "a DDS image"},
      {"8BPS"sv, "a Photoshop image"},
      {"\xabKTX"sv, "a KTX image"},
      {"sB"sv, "a Basis Universal image"},
      {"\0\0\0\x0cjP  "sv, "a JPEG 2000 image"},
      {"\xff\x0a"sv, "a JPEG XL image"},
      {"\0\0\0\x0cJXL "sv, "a JPEG XL image"},
      {"qoif"sv, "a QOI image"},
      {"<"sv, "text, such as a web page or SVG"},
  }};
  if (bytes.empty()) return "an empty file";
  for (const auto& [beginning, kind] : beginnings) {
    if (bytes.starts_with(beginning)) return kind;
  }
  if (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP")) return "a WebP image";
  if (bytes.size() > 8 && bytes.substr(4).starts_with("ftyp")) return "an AVIF or HEIF image";
  if (bytes.ends_with("TRUEVISION-XFILE.\0"sv)) return "a TGA image of a rare kind";
  return "no image of a known kind";
}

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
