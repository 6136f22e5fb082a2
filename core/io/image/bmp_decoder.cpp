#include <algorithm>
#include <bit>

#include "core/io/byte_reader.h"
#include "core/io/image/pixel_decoders.h"

namespace brume {
namespace {

class BmpDecoder {
 public:
  static constexpr std::uint32_t file_header = 14;
  static constexpr std::uint32_t core_header = 12;  // of OS/2; all others begin as Windows' of 40
  static constexpr std::uint32_t info_header = 40;

  BmpDecoder(const std::filesystem::path& file, std::string_view bytes)
      : file_(file), reader_(file, bytes), size_(bytes.size()) {}

  Pixels decode() {
    read_header();
    check_texture_size(file_, width_, height_);
    check_kind();
    read_masks();
    read_palette();
    reader_.seek(data_offset_);
    check_length();
    pixels_ = Pixels(static_cast<int>(width_), static_cast<int>(height_));
    if (is_packed()) {
      read_runs();
    } else {
      for (std::uint32_t y = 0; y < height_; ++y) read_row(y);
    }
    return std::move(pixels_);
  }

 private:
  enum Compression : std::uint32_t {
    none = 0,
    rle8 = 1,
    rle4 = 2,
    bit_fields = 3,
    alpha_fields = 6
  };

  void read_header() {
    reader_.seek(10);
    data_offset_ = reader_.number<std::uint32_t>();
    header_size_ = reader_.number<std::uint32_t>();
    if (header_size_ == core_header) {
      width_ = reader_.number<std::uint16_t>();
      height_ = reader_.number<std::uint16_t>();
    } else if (header_size_ >= info_header) {
      width_ = reader_.number<std::uint32_t>();
      const std::int64_t height = reader_.number<std::int32_t>();
      is_downward_ = height < 0;
      height_ = static_cast<std::uint32_t>(height < 0 ? -height : height);
    } else {
      reader_.fail("found a header of " + std::to_string(header_size_) +
                   " bytes; allowed: 12, or 40 and more");
    }
    reader_.number<std::uint16_t>();  // planes: always one
    bits_ = reader_.number<std::uint16_t>();
    if (header_size_ == core_header) return;
    compression_ = reader_.number<std::uint32_t>();
    reader_.seek(file_header + 32);
    colors_ = reader_.number<std::uint32_t>();
  }

  [[nodiscard]] bool is_packed() const { return compression_ == rle8 || compression_ == rle4; }
  [[nodiscard]] bool has_masks() const {
    return compression_ == bit_fields || compression_ == alpha_fields;
  }

  void check_kind() const {
    const bool is_valid = compression_ == none ? bits_ == 1 || bits_ == 4 || bits_ == 8 ||
                                                     bits_ == 16 || bits_ == 24 || bits_ == 32
                          : compression_ == rle8 ? bits_ == 8
                          : compression_ == rle4 ? bits_ == 4
                                                 : has_masks() && (bits_ == 16 || bits_ == 32);
    if (is_valid) return;
    reader_.fail("found a BMP of " + std::to_string(bits_) + " bits and compression " +
                 std::to_string(compression_) +
                 "; allowed: 1, 4, 8, 16, 24 or 32 bits, run lengths and bit fields");
  }

  // Masks follow the shortest header, and are within the longer ones.
  void read_masks() {
    if (bits_ == 16) masks_ = {0x7c00, 0x03e0, 0x001f, 0};
    if (!has_masks()) return;
    reader_.seek(file_header + info_header);
    const bool has_alpha = compression_ == alpha_fields || header_size_ >= info_header + 16;
    for (std::size_t k = 0; k < (has_alpha ? 4u : 3u); ++k) {
      masks_[k] = reader_.number<std::uint32_t>();
    }
  }

  void read_palette() {
    palette_.fill({0, 0, 0, 255});
    if (bits_ > 8) return;
    const bool has_masks_between = has_masks() && header_size_ == info_header;
    reader_.seek(file_header + std::uint64_t{header_size_} + (has_masks_between ? 12 : 0));
    const std::uint32_t most = 1u << bits_;
    const std::uint32_t count = colors_ == 0 ? most : std::min(colors_, most);
    for (std::uint32_t i = 0; i < count && reader_.position() < data_offset_; ++i) {
      const auto blue = reader_.number<std::uint8_t>();
      const auto green = reader_.number<std::uint8_t>();
      const auto red = reader_.number<std::uint8_t>();
      if (header_size_ != core_header) reader_.number<std::uint8_t>();
      palette_[i] = {red, green, blue, 255};
    }
  }

  // Checked before any memory is taken.
  void check_length() const {
    constexpr std::uint64_t max_run = 255;
    const std::uint64_t row = row_bytes();
    const std::uint64_t needed =
        is_packed() ? std::uint64_t{width_} * height_ / max_run : padded(row) * (height_ - 1) + row;
    if (needed > size_ - reader_.position()) {
      reader_.fail("declares more pixels than a file of this length holds");
    }
  }

  [[nodiscard]] std::uint64_t row_bytes() const { return (std::uint64_t{width_} * bits_ + 7) / 8; }
  static std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

  // Row `y` of the file, which begins at the bottom unless it says otherwise.
  void put(std::uint32_t x, std::uint32_t y, const Rgba& pixel) {
    pixels_.set(x, is_downward_ ? y : height_ - 1 - y, pixel);
  }

  void read_row(std::uint32_t y) {
    reader_.seek(data_offset_ + y * padded(row_bytes()));
    const std::string_view bytes = reader_.read_bytes(row_bytes());
    const auto byte = [bytes](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
    for (std::uint32_t x = 0; x < width_; ++x) {
      if (bits_ <= 8) {
        const std::uint64_t bit = std::uint64_t{x} * bits_;
        const unsigned index = byte(bit / 8) >> (8 - bits_ - bit % 8) & ((1u << bits_) - 1u);
        put(x, y, palette_[index]);
      } else if (bits_ == 16 || has_masks()) {
        std::uint32_t value = 0;
        for (unsigned k = 0; k < bits_ / 8u; ++k) {
          value |= std::uint32_t{byte(x * (bits_ / 8u) + k)} << (8 * k);
        }
        put(x, y, of_masks(value));
      } else {
        const std::size_t i = std::size_t{x} * (bits_ / 8u);
        put(x, y, {byte(i + 2), byte(i + 1), byte(i), 255});
      }
    }
  }

  [[nodiscard]] Rgba of_masks(std::uint32_t value) const {
    Rgba pixel{0, 0, 0, 255};
    for (std::size_t k = 0; k < 4; ++k) {
      if (masks_[k] == 0) continue;
      const int shift = std::countr_zero(masks_[k]);
      const std::uint64_t max_value = masks_[k] >> shift;
      const std::uint64_t scaled = ((value & masks_[k]) >> shift) * 255u;
      pixel[k] = static_cast<std::uint8_t>((scaled + max_value / 2) / max_value);
    }
    return pixel;
  }

  // Runs (count, value), and behind a 0 the end of a row (0) or of the picture (1), a jump (2), or
  // so many values each by itself. A value of RLE4 has two pixels. What is jumped over is the first
  // color.
  void read_runs() {
    for (std::uint32_t i = 0; i < height_; ++i) {
      for (std::uint32_t k = 0; k < width_; ++k) pixels_.set(k, i, palette_[0]);
    }
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    const auto add = [&](unsigned value, unsigned k) {
      const unsigned index = bits_ == 8 ? value : k % 2 == 0 ? value >> 4 : value & 15u;
      if (x < width_ && y < height_) put(x++, y, palette_[index]);
    };
    while (y < height_) {
      const unsigned count = reader_.number<std::uint8_t>();
      const unsigned value = reader_.number<std::uint8_t>();
      if (count > 0) {
        for (unsigned k = 0; k < count; ++k) add(value, k);
      } else if (value == 0) {
        x = 0;
        ++y;
      } else if (value == 1) {
        return;
      } else if (value == 2) {
        x += reader_.number<std::uint8_t>();
        y += reader_.number<std::uint8_t>();
      } else {
        const std::string_view bytes =
            reader_.read_bytes((value * bits_ + 15u) / 16u * 2u);  // whole words
        for (unsigned k = 0; k < value; ++k) {
          add(static_cast<std::uint8_t>(bytes[k * bits_ / 8u]), k);
        }
      }
    }
  }

  const std::filesystem::path& file_;
  ByteReader reader_;
  std::size_t size_;
  std::uint32_t data_offset_ = 0;
  std::uint32_t header_size_ = 0;
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  bool is_downward_ = false;
  std::uint16_t bits_ = 0;
  std::uint32_t compression_ = none;
  std::uint32_t colors_ = 0;  // of the palette; 0: as many as the bits allow
  std::array<std::uint32_t, 4> masks_{};
  std::array<Rgba, 256> palette_{};
  Pixels pixels_;
};

}  // namespace

bool is_bmp(std::string_view bytes) {
  return bytes.size() >= BmpDecoder::file_header + BmpDecoder::core_header &&
         bytes.starts_with("BM");
}

Pixels decode_bmp(const std::filesystem::path& file, std::string_view bytes) {
  return BmpDecoder(file, bytes).decode();
}

}  // namespace brume
