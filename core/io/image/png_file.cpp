#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <csetjmp>
#include <cstdio>
#include <new>
#include <sstream>
#include <string_view>

#include "brume/error.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/image/image_file.h"

namespace brume {
namespace {

constexpr std::size_t longest_keyword = 79;  // of a PNG text chunk

// libpng's errors jump out of its functions, so between setjmp and the jump nothing may live that
// has a destructor: hence plain pointers here, and the reason in a plain buffer.
struct Failure {
  std::jmp_buf jump;
  char reason[160];
};

[[noreturn]] void on_error(png_structp png, png_const_charp reason) {
  auto* failure = static_cast<Failure*>(png_get_error_ptr(png));
  std::snprintf(failure->reason, sizeof failure->reason, "%s", reason);
  std::longjmp(failure->jump, 1);
}

void on_warning(png_structp, png_const_charp) {}

void write_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  auto& out = *static_cast<std::ostream*>(png_get_io_ptr(png));
  try {
    out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  } catch (const std::ios_base::failure&) {  // which must not pass through libpng
  }
  if (!out) png_error(png, "the stream failed");
}

void flush_bytes(png_structp) {}

// R G B per pixel, or R G B A, rows from the top.
struct Image {
  int width;
  int height;
  std::span<const std::uint8_t> bytes;
  int bits;  // 8, or 16 in the byte order of this machine
  int channels = 3;

  Image(int image_width, int image_height, std::span<const std::uint8_t> values, int count = 3)
      : width(image_width), height(image_height), bytes(values), bits(8), channels(count) {
    assert(bytes.size() == static_cast<std::size_t>(height) * row_bytes());
  }
  Image(int image_width, int image_height, std::span<const std::uint16_t> rgb)
      : width(image_width),
        height(image_height),
        bytes(reinterpret_cast<const std::uint8_t*>(rgb.data()), rgb.size_bytes()),
        bits(16) {
    assert(bytes.size() == static_cast<std::size_t>(height) * row_bytes());
  }
  [[nodiscard]] std::size_t row_bytes() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) *
           static_cast<std::size_t>(bits / 8);
  }
};

bool write_image(std::ostream& out, const Image& image, png_textp texts, int text_count,
                 Failure& failure) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info == nullptr) {
    png_destroy_write_struct(&png, nullptr);
    std::snprintf(failure.reason, sizeof failure.reason, "not enough memory");
    return false;
  }
  // NOLINTNEXTLINE(cert-err52-cpp): libpng reports errors this way only
  if (setjmp(failure.jump) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_set_write_fn(png, &out, write_bytes, flush_bytes);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), image.bits,
               image.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  if (text_count > 0) png_set_text(png, info, texts, text_count);
  png_write_info(png, info);
  if (image.bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  for (int y = 0; y < image.height; ++y) {
    png_write_row(png, image.bytes.data() + static_cast<std::size_t>(y) * image.row_bytes());
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

void write_file(const std::filesystem::path& file, const Image& image,
                const std::map<std::string, std::string>& metadata) {
  std::vector<std::string> keywords;
  keywords.reserve(metadata.size());
  for (const auto& [key, value] : metadata) keywords.push_back(key.substr(0, longest_keyword));
  std::vector<png_text> texts;
  texts.reserve(metadata.size());
  for (const auto& [key, value] : metadata) {
    png_text text{};
    const bool is_ascii =
        std::all_of(value.begin(), value.end(), [](char c) { return (c & 0x80) == 0; });
    text.compression = is_ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = keywords[texts.size()].data();
    text.text = const_cast<char*>(value.c_str());  // libpng copies it
    text.text_length = is_ascii ? value.size() : 0;
    text.itxt_length = is_ascii ? 0 : value.size();
    texts.push_back(text);
  }
  write_atomically(file, [&](std::ostream& out) {
    Failure failure{};
    const bool written =
        write_image(out, image, texts.data(), static_cast<int>(texts.size()), failure);
    if (!written && out) {
      throw InputError(file, "", std::string("cannot be written: ") + failure.reason);
    }
  });
}

// The number at the begin of `bytes`, of at least four.
std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

}  // namespace

std::map<std::string, std::string> read_png_texts(const std::filesystem::path& file) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
  const std::string bytes = read_bytes(file);
  std::string_view rest = bytes;
  if (!rest.starts_with(signature)) throw InputError(file, "header", "not a PNG file");
  rest.remove_prefix(signature.size());
  std::map<std::string, std::string> texts;
  for (;;) {
    // Length, type, content, checksum of the last two.
    const std::uint32_t length = rest.size() < 12 ? 0 : big_endian(rest);
    if (rest.size() < 12 || length > rest.size() - 12) throw InputError(file, "", "is incomplete");
    const std::string_view checked = rest.substr(4, 4 + std::size_t{length});
    const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(checked.data()),
                             static_cast<uInt>(checked.size()));
    if (sum != big_endian(rest.substr(8 + length))) throw InputError(file, "", "is damaged");
    const std::string_view content = checked.substr(4);
    if (checked.starts_with("IEND")) return texts;
    if (checked.starts_with("tEXt")) {
      const std::size_t end = content.find('\0');
      if (end != std::string_view::npos) {
        texts[std::string(content.substr(0, end))] = content.substr(end + 1);
      }
    }
    rest.remove_prefix(12 + std::size_t{length});
  }
}

void write_png(const std::filesystem::path& file, int width, int height,
               std::span<const std::uint8_t> rgb,
               const std::map<std::string, std::string>& metadata) {
  write_file(file, {width, height, rgb}, metadata);
}

void write_png(const std::filesystem::path& file, int width, int height,
               std::span<const std::uint16_t> rgb,
               const std::map<std::string, std::string>& metadata) {
  write_file(file, {width, height, rgb}, metadata);
}

void write_png_with_alpha(const std::filesystem::path& file, int width, int height,
                          std::span<const std::uint8_t> rgba) {
  write_file(file, {width, height, rgba, 4}, {});
}

std::string encode_png(int width, int height, std::span<const std::uint8_t> rgb) {
  std::ostringstream out;
  Failure failure{};
  if (!write_image(out, {width, height, rgb}, nullptr, 0, failure)) throw std::bad_alloc();
  return std::move(out).str();
}

}  // namespace brume
