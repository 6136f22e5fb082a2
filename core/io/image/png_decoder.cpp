#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <string>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/image/pixel_decoders.h"

namespace brume {
namespace {

// Nothing with a destructor lives between setjmp and the jump, as when writing (png_file.cpp): what
// does is a member here.
class PngDecoder {
 public:
  PngDecoder(const std::filesystem::path& file, std::string_view bytes)
      : file_(file), bytes_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;

  Pixels decode() {
    if (info_ == nullptr) refuse("not enough memory");
    // Before libpng reads on: the size is in the first chunk.
    if (is_png(bytes_) && bytes_.size() >= 24 && bytes_.substr(12, 4) == "IHDR") {
      check_texture_size(file_, big_endian(16), big_endian(20));
    }
    if (!read_header()) refuse(reason_);
    // Deflate packs at most 1032 bytes into one.
    constexpr std::size_t max_ratio = 1032;
    const std::size_t rows = png_get_image_height(png_, info_);
    if (rows * png_get_rowbytes(png_, info_) > max_ratio * bytes_.size()) {
      refuse("declares more pixels than a file of this length holds");
    }
    if (!begin_pixels()) refuse(reason_);
    const std::size_t row_bytes = 4 * std::size_t{png_get_image_width(png_, info_)};
    if (png_get_rowbytes(png_, info_) != row_bytes) refuse("has an unknown kind of pixels");
    pixels_ = Pixels(static_cast<int>(png_get_image_width(png_, info_)), static_cast<int>(rows));
    for (std::size_t y = 0; y < rows; ++y) rows_.push_back(pixels_.row(y));
    if (!read_pixels()) refuse(reason_);
    return std::move(pixels_);
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    throw InputError(file_, "", "cannot be read as PNG: " + reason);
  }

  [[noreturn]] static void fail(png_structp png, png_const_charp reason) {
    auto& decoder = *static_cast<PngDecoder*>(png_get_error_ptr(png));
    std::snprintf(decoder.reason_, sizeof decoder.reason_, "%s", reason);
    std::longjmp(decoder.jump_, 1);
  }
  static void ignore(png_structp, png_const_charp) {}

  [[nodiscard]] std::uint32_t big_endian(std::size_t at) const {
    std::uint32_t value = 0;
    for (const char byte : bytes_.substr(at, 4))
      value = value << 8 | static_cast<unsigned char>(byte);
    return value;
  }

  static void read_bytes(png_structp png, png_bytep to, std::size_t count) {
    auto& decoder = *static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (count > decoder.bytes_.size() - decoder.position_)
      png_error(png, "the file ends too early");
    std::memcpy(to, decoder.bytes_.data() + decoder.position_, count);
    decoder.position_ += count;
  }

  bool read_header() {
    // NOLINTNEXTLINE(cert-err52-cpp): libpng reports errors this way only
    if (setjmp(jump_) != 0) return false;
    png_set_read_fn(png_, this, read_bytes);
    png_set_user_limits(png_, 0x7fffffff, 0x7fffffff);  // what is too large has its own message
    png_set_chunk_malloc_max(png_, png_alloc_size_t{8} << 20);
    png_read_info(png_, info_);
    return true;
  }

  bool begin_pixels() {
    // NOLINTNEXTLINE(cert-err52-cpp)
    if (setjmp(jump_) != 0) return false;
    png_set_scale_16(png_);
    png_set_expand(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  bool read_pixels() {
    // NOLINTNEXTLINE(cert-err52-cpp)
    if (setjmp(jump_) != 0) return false;
    png_read_image(png_, rows_.data());
    png_read_end(png_, nullptr);
    return true;
  }

  const std::filesystem::path& file_;
  std::string_view bytes_;
  std::size_t position_ = 0;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  Pixels pixels_;
  std::vector<png_bytep> rows_;
  std::jmp_buf jump_{};
  char reason_[160] = "";
};

}  // namespace

bool is_png(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1a\n");
}

Pixels decode_png(const std::filesystem::path& file, std::string_view bytes) {
  return PngDecoder(file, bytes).decode();
}

void check_texture_size(const std::filesystem::path& file, std::uint64_t width,
                        std::uint64_t height) {
  const auto is_allowed = [](std::uint64_t side) {
    return side >= 1 && side <= static_cast<std::uint64_t>(limits::texture_side);
  };
  if (is_allowed(width) && is_allowed(height)) return;
  throw InputError(file, "header",
                   "found an image of " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels; allowed: 1 to " + std::to_string(limits::texture_side) +
                       " a side");
}

}  // namespace brume
