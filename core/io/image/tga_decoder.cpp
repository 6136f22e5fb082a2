#include "core/io/byte_reader.h"
#include "core/io/image/pixel_decoders.h"

namespace brume {
namespace {

// The header of a TGA, byte by byte as the file has it.
struct TgaHeader {
  std::uint8_t id_length = 0;
  std::uint8_t has_palette = 0;
  std::uint8_t type = 0;
  std::uint16_t palette_first = 0;
  std::uint16_t palette_count = 0;
  std::uint8_t palette_bits = 0;
  std::uint16_t width = 0;
  std::uint16_t height = 0;
  std::uint8_t bits = 0;
  std::uint8_t descriptor = 0;

  [[nodiscard]] bool is_packed() const { return (type & 8) != 0; }
  [[nodiscard]] bool is_indexed() const { return (type & 7) == 1; }
  [[nodiscard]] bool is_gray() const { return (type & 7) == 3; }
  [[nodiscard]] bool has_alpha() const { return (descriptor & 0x0f) != 0; }
};

constexpr std::size_t tga_header_bytes = 18;

TgaHeader read_tga_header(ByteReader& reader) {
  TgaHeader header;
  header.id_length = reader.number<std::uint8_t>();
  header.has_palette = reader.number<std::uint8_t>();
  header.type = reader.number<std::uint8_t>();
  header.palette_first = reader.number<std::uint16_t>();
  header.palette_count = reader.number<std::uint16_t>();
  header.palette_bits = reader.number<std::uint8_t>();
  reader.number<std::uint32_t>();  // where a screen showed it
  header.width = reader.number<std::uint16_t>();
  header.height = reader.number<std::uint16_t>();
  header.bits = reader.number<std::uint8_t>();
  header.descriptor = reader.number<std::uint8_t>();
  return header;
}

bool has_tga_color(std::uint8_t bits) {
  return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

class TgaDecoder {
 public:
  TgaDecoder(const std::filesystem::path& file, std::string_view bytes)
      : reader_(file, bytes), size_(bytes.size()), header_(read_tga_header(reader_)) {
    check_texture_size(file, header_.width, header_.height);
  }

  Pixels decode() {
    reader_.read_bytes(header_.id_length);
    read_palette();
    const std::size_t count = std::size_t{header_.width} * header_.height;
    const std::size_t pixel_bytes = (header_.bits + 7u) / 8u;
    constexpr std::size_t max_run = 128;
    const std::size_t min_bytes =
        header_.is_packed() ? count / max_run * (1 + pixel_bytes) : count * pixel_bytes;
    if (min_bytes > size_ - reader_.position()) {
      reader_.fail("declares more pixels than a file of this length holds");
    }
    Pixels pixels(header_.width, header_.height);
    if (header_.is_packed()) {
      read_packets(pixels, count);
    } else {
      for (std::size_t i = 0; i < count; ++i) put(pixels, i, next_pixel());
    }
    return pixels;
  }

 private:
  void read_palette() {
    if (header_.has_palette == 0) return;
    if (!has_tga_color(header_.palette_bits)) {
      reader_.fail("found a palette of " + std::to_string(header_.palette_bits) +
                   " bits; allowed: 15, 16, 24 or 32");
    }
    for (std::size_t i = 0; i < header_.palette_count; ++i) {
      palette_.push_back(next_color(header_.palette_bits));
    }
  }

  // Packets of 1 to 128 pixels: one that is repeated, or each by itself. They may go on from row to
  // row.
  void read_packets(Pixels& pixels, std::size_t count) {
    for (std::size_t i = 0; i < count;) {
      const auto code = reader_.number<std::uint8_t>();
      const std::size_t end = i + (code & 0x7fu) + 1u;
      if (end > count) reader_.fail("found a run beyond the last pixel");
      if ((code & 0x80) != 0) {
        const Rgba pixel = next_pixel();
        while (i < end) put(pixels, i++, pixel);
      } else {
        while (i < end) put(pixels, i++, next_pixel());
      }
    }
  }

  // The pixel that the file has at position `i`, whose rows may run up and to the left.
  void put(Pixels& pixels, std::size_t i, const Rgba& pixel) const {
    const std::size_t width = header_.width;
    const bool is_leftward = (header_.descriptor & 0x10) != 0;
    const bool is_downward = (header_.descriptor & 0x20) != 0;
    const std::size_t x = is_leftward ? width - 1 - i % width : i % width;
    const std::size_t y = is_downward ? i / width : header_.height - 1 - i / width;
    pixels.set(x, y, pixel);
  }

  Rgba next_pixel() {
    if (header_.is_indexed()) {
      const std::size_t index =
          header_.bits == 8 ? reader_.number<std::uint8_t>() : reader_.number<std::uint16_t>();
      // An index below the first, which wraps around, is none either.
      const std::size_t entry = index - header_.palette_first;
      if (entry < palette_.size()) return palette_[entry];
      reader_.fail("found the palette index " + std::to_string(index) +
                   "; allowed: " + std::to_string(palette_.size()) + " from " +
                   std::to_string(header_.palette_first));
    }
    if (!header_.is_gray()) return next_color(header_.bits);
    const auto gray = reader_.number<std::uint8_t>();
    const std::uint8_t alpha = header_.bits == 16 ? reader_.number<std::uint8_t>() : 255;
    return {gray, gray, gray, alpha};
  }

  Rgba next_color(std::uint8_t bits) {
    if (bits <= 16) {
      const auto value = reader_.number<std::uint16_t>();
      const auto five = [value](unsigned shift) {
        return static_cast<std::uint8_t>(((value >> shift & 31u) * 255u + 15u) / 31u);
      };
      return {five(10), five(5), five(0), 255};
    }
    const auto blue = reader_.number<std::uint8_t>();
    const auto green = reader_.number<std::uint8_t>();
    const auto red = reader_.number<std::uint8_t>();
    const std::uint8_t alpha = bits == 32 ? reader_.number<std::uint8_t>() : 255;
    return {red, green, blue, header_.has_alpha() ? alpha : std::uint8_t{255}};
  }

  ByteReader reader_;
  std::size_t size_;
  TgaHeader header_;
  std::vector<Rgba> palette_;
};

}  // namespace

bool is_tga(std::string_view bytes) {
  if (bytes.size() < tga_header_bytes) return false;
  ByteReader reader({}, bytes);
  const TgaHeader header = read_tga_header(reader);
  const bool is_interleaved = (header.descriptor & 0xc0) != 0;
  if (header.has_palette > 1 || is_interleaved || (header.type & ~8) == 0 || header.type > 11) {
    return false;
  }
  if (header.is_indexed()) {
    return header.has_palette == 1 && (header.bits == 8 || header.bits == 16);
  }
  if (header.is_gray()) return header.bits == 8 || header.bits == 16;
  return (header.type & 7) == 2 && has_tga_color(header.bits);
}

Pixels decode_tga(const std::filesystem::path& file, std::string_view bytes) {
  return TgaDecoder(file, bytes).decode();
}

}  // namespace brume
