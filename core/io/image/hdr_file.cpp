#include "core/io/image/hdr_file.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

// Pixels beyond these must be backed by the file: the run-length code makes at most 16 of a byte.
constexpr std::size_t free_pixels = std::size_t{1} << 22;
constexpr std::size_t best_compression = 16;

using Rgbe = std::array<std::uint8_t, 4>;

glm::vec3 radiance(const Rgbe& pixel, const glm::dvec3& exposure) {
  if (pixel[3] == 0) return glm::vec3(0.0f);
  // The byte encodes the center of the values that round to it, as in Radiance's library.
  const double unit = std::ldexp(1.0, pixel[3] - (128 + 8));
  return {(glm::dvec3(pixel[0], pixel[1], pixel[2]) + 0.5) * unit / exposure};
}

// One side of a picture, as "-Y 480": which, and whether the file has it from the right or the top.
struct HdrSide {
  bool is_width = false;
  bool is_descending = false;
  std::size_t length = 0;

  // The column, or the row from the top, of what the file has at position `i`.
  [[nodiscard]] std::size_t place(std::size_t i) const {
    return is_width == is_descending ? length - 1 - i : i;
  }
};

struct Header {
  HdrSide lines;   // that the file has one after the other: rows of the picture, or columns
  HdrSide pixels;  // of a line
  glm::dvec3 exposure{1.0};
};

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

// Whether a text begins with an axis of the size, which ends the header.
bool begins_with_axis(std::string_view text) {
  return text.size() >= 2 && (text[0] == '-' || text[0] == '+') &&
         (text[1] == 'X' || text[1] == 'Y');
}

class HdrReader {
 public:
  HdrReader(const fs::path& file, std::string_view bytes) : file_(file), header_(bytes) {}

  RadianceMap read() {
    const Header header = read_header();
    data_ = header_.rest_of_text();
    const std::size_t pixels = header.lines.length * header.pixels.length;
    if (pixels > free_pixels && pixels / best_compression > data_.size()) {
      fail_header("found " + std::to_string(pixels) + " pixels; the file is too short for them");
    }
    if (pixels * sizeof(glm::vec3) > limits::scene_bytes) {
      fail_header("found " + std::to_string(pixels) + " pixels; allowed: at most " +
                  std::to_string(limits::scene_bytes / sizeof(glm::vec3)));
    }
    const bool has_rows = header.pixels.is_width;
    const HdrSide& width = has_rows ? header.pixels : header.lines;
    const HdrSide& height = has_rows ? header.lines : header.pixels;
    RadianceMap map{static_cast<int>(width.length), static_cast<int>(height.length), {}};
    map.pixels.resize(pixels);
    std::vector<Rgbe> line(header.pixels.length);
    for (row_ = 0; row_ < header.lines.length; ++row_) {
      read_row(line);
      for (std::size_t i = 0; i < line.size(); ++i) {
        const std::size_t x = width.place(has_rows ? i : row_);
        const std::size_t y = height.place(has_rows ? row_ : i);
        map.pixels[y * width.length + x] = radiance(line[i], header.exposure);
      }
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
    do {
      if (!header_.next_line()) fail_header("the header ends without an empty line");
      read_variable(header);
    } while (!without_blanks(header_.rest_of_line()).empty() &&
             !begins_with_axis(header_.rest_of_line()));
    for (int k = 0; k < 3; ++k) {
      if (header.exposure[k] >= 1e-12 && header.exposure[k] <= 1e12) continue;
      fail_header("the exposures multiply to " + std::to_string(header.exposure[k]) +
                  "; allowed: 1e-12 to 1e12");
    }
    while (without_blanks(header_.rest_of_line()).empty()) {
      if (!header_.next_line()) fail_header("the file ends before the size");
    }
    read_size(header);
    return header;
  }

  // "EXPOSURE=2", "COLORCORR=1 1 .9", "FORMAT=..."; others say nothing of the radiance.
  void read_variable(Header& header) const {
    const std::string_view line = header_.rest_of_line();
    const std::size_t equals = line.find('=');
    if (equals == line.npos) return;
    const std::string_view name = without_blanks(line.substr(0, equals));
    const std::string_view value = without_blanks(line.substr(equals + 1));
    if (name == "FORMAT" && value != "32-bit_rle_rgbe") {
      fail_header("found " + quoted_text(line) + "; allowed: FORMAT=32-bit_rle_rgbe");
    }
    if (name == "EXPOSURE") header.exposure *= read_exposure(value, 1);
    if (name == "COLORCORR") header.exposure *= read_exposure(value, 3);
  }

  // One factor for all colors, or one for each.
  [[nodiscard]] glm::dvec3 read_exposure(std::string_view text, int count) const {
    TextScanner value(text);
    value.next_line();
    glm::dvec3 factors;
    for (int k = 0; k < count; ++k) {
      const std::optional<double> factor = parse_number(value.next_token());
      if (!factor || !(*factor > 0.0)) {
        fail_header("found an exposure of " + quoted_text(text) + "; allowed: a number > 0");
      }
      factors[k] = *factor;
    }
    return count == 1 ? glm::dvec3(factors[0]) : factors;
  }

  void read_size(Header& header) {
    const std::string line(header_.rest_of_line());
    for (HdrSide* side : {&header.lines, &header.pixels}) {
      const std::string_view axis = header_.next_token();
      const std::optional<std::int64_t> length = parse_integer(header_.next_token());
      if (axis.size() != 2 || !begins_with_axis(axis) || !length || *length < 1 ||
          *length > limits::image_side) {
        fail_size(line);
      }
      *side = {axis[1] == 'X', axis[0] == '-', static_cast<std::size_t>(*length)};
    }
    if (header.lines.is_width == header.pixels.is_width || !header_.next_token().empty()) {
      fail_size(line);
    }
  }

  [[noreturn]] void fail_size(const std::string& line) const {
    fail_header("found the size " + quoted_text(line) +
                "; allowed: -Y HEIGHT +X WIDTH, with either sign and in either order, 1 to " +
                std::to_string(limits::image_side) + " a side");
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
  std::size_t row_ = 0;
};

}  // namespace

RadianceMap read_hdr(const fs::path& file) {
  const std::string bytes = read_bytes(file);
  return HdrReader(file, bytes).read();
}

}  // namespace brume
