#include <csetjmp>
#include <cstdio>
#include <string>
// libjpeg's headers need <cstdio> before them.
#include <jpeglib.h>

#include <jerror.h>

#include "brume/error.h"
#include "core/io/image/pixel_decoders.h"

namespace brume {
namespace {

// A progressive file may repeat scans that cost much and say nothing; encoders write about ten.
constexpr int max_scans = 100;

// See PngDecoder: nothing with a destructor lives between setjmp and the jump.
class JpegDecoder {
 public:
  JpegDecoder(const std::filesystem::path& file, std::string_view bytes)
      : file_(file), bytes_(bytes) {
    jpeg_.err = jpeg_std_error(&errors_);
    jpeg_.client_data = this;
    errors_.error_exit = fail;
    errors_.emit_message = warn;
    errors_.output_message = [](j_common_ptr) {};
    progress_.progress_monitor = limit_scans;
  }
  ~JpegDecoder() { jpeg_destroy_decompress(&jpeg_); }
  JpegDecoder(const JpegDecoder&) = delete;
  JpegDecoder& operator=(const JpegDecoder&) = delete;

  Pixels decode() {
    if (!read_header()) refuse(reason_);
    check_texture_size(file_, jpeg_.image_width, jpeg_.image_height);
    // A Huffman code takes at least a bit of each 8 x 8 pixels.
    constexpr std::size_t max_ratio = 512;
    const std::size_t pixels = std::size_t{jpeg_.image_width} * jpeg_.image_height;
    if (jpeg_.arith_code == FALSE && pixels > max_ratio * bytes_.size()) {
      refuse("declares more pixels than a file of this length holds");
    }
    if (!begin_pixels()) refuse(reason_);
    pixels_ = Pixels(static_cast<int>(jpeg_.output_width), static_cast<int>(jpeg_.output_height));
    if (!read_pixels()) refuse(reason_);
    if (jpeg_.out_color_space == JCS_CMYK) convert_inks();
    return std::move(pixels_);
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    throw InputError(file_, "", "cannot be read as JPEG: " + reason);
  }

  [[noreturn]] static void fail(j_common_ptr jpeg) {
    auto& decoder = *static_cast<JpegDecoder*>(jpeg->client_data);
    static_assert(sizeof decoder.reason_ >= JMSG_LENGTH_MAX);
    jpeg->err->format_message(jpeg, decoder.reason_);
    std::longjmp(decoder.jump_, 1);
  }
  // A file that is cut short would be filled up with gray.
  static void warn(j_common_ptr jpeg, int level) {
    if (level < 0 && jpeg->err->msg_code == JWRN_JPEG_EOF) fail(jpeg);
  }
  static void limit_scans(j_common_ptr jpeg) {
    auto& decoder = *static_cast<JpegDecoder*>(jpeg->client_data);
    if (decoder.jpeg_.input_scan_number <= max_scans) return;
    std::snprintf(decoder.reason_, sizeof decoder.reason_, "it has more than %d scans", max_scans);
    std::longjmp(decoder.jump_, 1);
  }

  bool read_header() {
    // NOLINTNEXTLINE(cert-err52-cpp): libjpeg reports errors this way only
    if (setjmp(jump_) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    jpeg_.progress = &progress_;
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
    jpeg_read_header(&jpeg_, TRUE);
    return true;
  }

  bool begin_pixels() {
    // NOLINTNEXTLINE(cert-err52-cpp)
    if (setjmp(jump_) != 0) return false;
    const bool has_inks = jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK;
    jpeg_.out_color_space = has_inks ? JCS_CMYK : JCS_EXT_RGBA;
    jpeg_start_decompress(&jpeg_);
    return true;
  }

  bool read_pixels() {
    // NOLINTNEXTLINE(cert-err52-cpp)
    if (setjmp(jump_) != 0) return false;
    while (jpeg_.output_scanline < jpeg_.output_height) {
      JSAMPROW row = pixels_.row(jpeg_.output_scanline);
      jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
  }

  // Cyan, magenta, yellow and black of a file, without its profile; Adobe's programs write how much
  // of each is missing.
  void convert_inks() {
    const auto left_over = [this](std::uint8_t ink) -> unsigned {
      return jpeg_.saw_Adobe_marker ? ink : 255u - ink;
    };
    for (std::uint32_t& texel : pixels_.rgba) {
      auto* pixel = reinterpret_cast<std::uint8_t*>(&texel);
      for (std::size_t k = 0; k < 3; ++k) {
        pixel[k] = static_cast<std::uint8_t>(left_over(pixel[k]) * left_over(pixel[3]) / 255u);
      }
      pixel[3] = 255;
    }
  }

  const std::filesystem::path& file_;
  std::string_view bytes_;
  jpeg_decompress_struct jpeg_{};
  jpeg_error_mgr errors_{};
  jpeg_progress_mgr progress_{};
  Pixels pixels_;
  std::jmp_buf jump_{};
  char reason_[JMSG_LENGTH_MAX] = "";
};

}  // namespace

bool is_jpeg(std::string_view bytes) {
  return bytes.starts_with("\xff\xd8\xff");
}

Pixels decode_jpeg(const std::filesystem::path& file, std::string_view bytes) {
  return JpegDecoder(file, bytes).decode();
}

}  // namespace brume
