#include "core/io/image/hdr_file.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/file_bytes.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

// Pixels beyond these must be backed by the file: the run-length code makes at most 16 of a byte.
constexpr std::size_t free_pixels = std::size_t{1} << 22;
constexpr std::size_t best_compression = 16;

using Rgbe = std::array<std::uint8_t, 4>;

glm::vec3 radiance(const Rgbe& pixel, double scale) {
  if (pixel[3] == 0) return glm::vec3(0.0f);
  // The byte encodes the center of the values that round to it, as in Radiance's library.
  const double unit = scale * std::ldexp(1.0, pixel[3] - (128 + 8));
  return {(glm::dvec3(pixel[0], pixel[1], pixel[2]) + 0.5) * unit};
}

struct Header {
  int width = 0;
  int height = 0;
  double exposure = 1.0;
};

class HdrReader {
 public:
  HdrReader(const fs::path& file, std::string_view bytes) : file_(file), header_(bytes) {}

  RadianceMap read() {
    const Header header = read_header();
    data_ = header_.rest_of_text();
    const auto width = static_cast<std::size_t>(header.width);
    const std::size_t pixels = width * static_cast<std::size_t>(header.height);
    if (pixels > free_pixels && pixels / best_compression > data_.size()) {
      fail_header("found " + std::to_string(pixels) + " pixels; the file is too short for them");
    }
    if (pixels * sizeof(glm::vec3) > limits::scene_bytes) {
      fail_header("found " + std::to_string(pixels) + " pixels; allowed: at most " +
                  std::to_string(limits::scene_bytes / sizeof(glm::vec3)));
    }
    RadianceMap map{header.width, header.height, {}};
    map.pixels.reserve(pixels);
    std::vector<Rgbe> row(width);
    for (row_ = 0; row_ < header.height; ++row_) {
      read_row(row);
      for (const Rgbe& pixel : row) map.pixels.push_back(radiance(pixel, 1.0 / header.exposure));
    }
    if (!data_.empty()) {
      throw InputError(
          file_, "",
          "found " + std::to_string(data_.size()) + " bytes after the last row; allowed: none");
    }
    return map;
  }

 private:
  [[noreturn]] void fail_header(const std::string& message) const {
    throw InputError(file_, header_.place(), message);
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(file_, "row " + std::to_string(row_), message);
  }

  Header read_header() {
    if (!header_.next_line() || !header_.rest_of_line().starts_with("#?")) {
      fail_header("not a Radiance HDR image");
    }
    Header header;
    for (;;) {
      if (!header_.next_line()) fail_header("the header ends without an empty line");
      const std::string_view line = header_.rest_of_line();
      if (line.empty()) break;
      if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe") {
        fail_header("found " + quoted_text(line) + "; allowed: FORMAT=32-bit_rle_rgbe");
      }
      if (line.starts_with("EXPOSURE=")) header.exposure *= read_exposure();
    }
    if (!(header.exposure >= 1e-12 && header.exposure <= 1e12)) {
      fail_header("the exposures multiply to " + std::to_string(header.exposure) +
                  "; allowed: 1e-12 to 1e12");
    }
    if (!header_.next_line()) fail_header("the file ends before the size");
    const std::string line(header_.rest_of_line());
    const std::string_view y = header_.next_token();
    const std::optional<std::int64_t> height = parse_integer(header_.next_token());
    const std::string_view x = header_.next_token();
    const std::optional<std::int64_t> width = parse_integer(header_.next_token());
    const auto is_side = [](std::optional<std::int64_t> n) {
      return n && *n >= 1 && *n <= limits::image_side;
    };
    if (y != "-Y" || x != "+X" || !is_side(height) || !is_side(width) ||
        !header_.next_token().empty()) {
      fail_header("found the size " + quoted_text(line) + "; allowed: -Y HEIGHT +X WIDTH, 1 to " +
                  std::to_string(limits::image_side) + " a side");
    }
    header.width = static_cast<int>(*width);
    header.height = static_cast<int>(*height);
    return header;
  }

  double read_exposure() {
    const std::string_view text =
        header_.rest_of_line().substr(std::string_view("EXPOSURE=").size());
    TextScanner value(text);
    value.next_line();
    const std::optional<double> exposure = parse_number(value.next_token());
    if (!exposure || !(*exposure > 0.0)) {
      fail_header("found an exposure of " + quoted_text(text) + "; allowed: a number > 0");
    }
    return *exposure;
  }

  std::uint8_t next_byte() {
    if (data_.empty()) fail("the file ends here");
    const auto byte = static_cast<std::uint8_t>(data_.front());
    data_.remove_prefix(1);
    return byte;
  }

  Rgbe next_pixel() {
    Rgbe pixel;
    for (std::uint8_t& byte : pixel) byte = next_byte();
    return pixel;
  }

  void read_row(std::span<Rgbe> row) {
    const std::size_t width = row.size();
    const Rgbe first = next_pixel();
    const bool by_component =
        width >= 8 && width < 32768 && first[0] == 2 && first[1] == 2 && first[2] < 128;
    if (!by_component) {
      read_pixels(first, row);
      return;
    }
    if (first[2] * std::size_t{256} + first[3] != width) {
      fail("found a width of " + std::to_string(first[2] * 256 + first[3]) +
           "; allowed: " + std::to_string(width));
    }
    for (std::size_t component = 0; component < 4; ++component) read_component(component, row);
  }

  // Flat, or the old code: a pixel 1 1 1 n repeats the one before n times, and such pixels on end
  // are the bytes of one count, the lowest first.
  void read_pixels(Rgbe pixel, std::span<Rgbe> row) {
    std::size_t x = 0;
    int shift = 0;
    for (;;) {
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        if (x == 0 || shift > 16) fail("found a run without a pixel before it");
        const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
        if (count > row.size() - x) fail("found a run beyond the end of the row");
        for (std::size_t i = 0; i < count; ++i, ++x) row[x] = row[x - 1];
        shift += 8;
      } else {
        row[x++] = pixel;
        shift = 0;
      }
      if (x == row.size()) return;
      pixel = next_pixel();
    }
  }

  // The newer code: each component of the row by itself, runs (128 + n, value) and stretches
  // (n, values).
  void read_component(std::size_t component, std::span<Rgbe> row) {
    for (std::size_t x = 0; x < row.size();) {
      const std::uint8_t code = next_byte();
      const bool is_run = code > 128;
      const std::size_t count = is_run ? code - std::size_t{128} : code;
      if (count == 0 || count > row.size() - x) {
        fail("found a run of " + std::to_string(count) + " at column " + std::to_string(x) +
             "; allowed: 1 to the end of the row");
      }
      std::uint8_t value = is_run ? next_byte() : std::uint8_t{0};
      for (std::size_t i = 0; i < count; ++i, ++x) {
        if (!is_run) value = next_byte();
        row[x][component] = value;
      }
    }
  }

  const fs::path& file_;
  TextScanner header_;
  std::string_view data_;
  int row_ = 0;
};

}  // namespace

RadianceMap read_hdr(const fs::path& file) {
  const std::string bytes = read_bytes(file);
  return HdrReader(file, bytes).read();
}

}  // namespace brume
