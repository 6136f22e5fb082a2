#include "core/io/image/image_kind.h"

#include <array>
#include <utility>

namespace brume {

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

}  // namespace brume
