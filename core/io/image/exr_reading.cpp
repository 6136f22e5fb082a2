#include "core/io/image/exr_reading.h"

#include <ImfChannelList.h>
#include <ImfTileDescription.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

#include "brume/limits.h"
#include "core/io/disk/file_bytes.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t max_channels = 1024;
constexpr std::uint32_t is_multipart = 0x1000;  // a flag of the version
constexpr std::size_t max_name = 255;

// Every file may have so many bytes of pixels, and a block of rows or tiles so many more than all
// of its image: images of a few pixels have tiles too.
constexpr std::uintmax_t free_pixel_bytes = std::uintmax_t{1} << 20;
constexpr std::uintmax_t free_block_bytes = std::uintmax_t{1} << 26;

// Walks over the headers of a file, attribute by attribute.
class Headers {
 public:
  explicit Headers(const fs::path& file)
      : file_(file), size_(regular_file_size(file)), in_(file, std::ios::binary) {}

  void check() {
    skip(4);  // what makes it an OpenEXR file
    const bool has_parts = (number() & is_multipart) != 0;
    // The headers of parts end with one that is empty.
    while (header() && has_parts) {
    }
  }

 private:
  // Whether there was any attribute.
  bool header() {
    bool any = false;
    for (std::string name = text(); !name.empty(); name = text()) {
      text();  // its type
      const std::uint32_t bytes = number();
      if (bytes > size_ - position_) {
        throw InputError(file_, "header, attribute " + quoted_text(name),
                         "claims " + std::to_string(bytes) + " bytes; the file ends before");
      }
      skip(bytes);
      any = true;
    }
    return any;
  }

  std::string text() {
    std::array<char, max_name + 2> name{};
    if (!in_.getline(name.data(), name.size(), '\0') || in_.eof()) end();
    const std::size_t length = std::strlen(name.data());
    position_ += length + 1;
    return {name.data(), length};
  }

  // In the byte order of the file, the lowest first.
  std::uint32_t number() {
    std::array<unsigned char, 4> bytes{};
    if (!in_.read(reinterpret_cast<char*>(bytes.data()), bytes.size())) end();
    position_ += bytes.size();
    return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
  }

  void skip(std::uint32_t bytes) {
    position_ += bytes;
    if (!in_.seekg(static_cast<std::streamoff>(position_))) end();
  }

  [[noreturn]] void end() const {
    throw InputError(file_, "header", "not a readable OpenEXR file: the header has no end");
  }

  const fs::path& file_;
  std::uintmax_t size_;
  std::uintmax_t position_ = 0;
  std::ifstream in_;
};

struct Block {
  std::uintmax_t rows;
  std::uintmax_t best_compression;  // of its pixels, rounded up
};

// Deflate makes 1032 bytes of one. DWA keeps a number of 64 pixels, coded again.
Block block_of(Imf::Compression compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return {1, 1};
    case Imf::RLE_COMPRESSION:
      return {1, 64};
    case Imf::ZIPS_COMPRESSION:
      return {1, 1100};
    case Imf::ZIP_COMPRESSION:
      return {16, 1100};
    case Imf::PXR24_COMPRESSION:
      return {16, 1500};
    case Imf::PIZ_COMPRESSION:
      return {32, 1100};
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
      return {32, 11};
    case Imf::DWAA_COMPRESSION:
      return {32, 50'000};
    case Imf::DWAB_COMPRESSION:
    default:
      return {256, 50'000};
  }
}

std::string sides(std::uintmax_t width, std::uintmax_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

void check_exr_attributes(const fs::path& file) {
  Headers(file).check();
}

void check_exr_image(const fs::path& file, const Imf::Header& header) {
  const Imath::Box2i& window = header.dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  if (width < 1 || height < 1 || width > limits::image_side || height > limits::image_side) {
    throw InputError(file, "header",
                     "found a size of " + std::to_string(width) + " x " + std::to_string(height) +
                         "; allowed: 1 to " + std::to_string(limits::image_side) + " a side");
  }
  const auto columns = static_cast<std::uintmax_t>(width);
  const auto rows = static_cast<std::uintmax_t>(height);
  std::uintmax_t channels = 0;
  std::uintmax_t stored = 0;  // bytes before compression
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c, ++channels) {
    const auto every = [](int sampling) {
      return static_cast<std::uintmax_t>(std::max(sampling, 1));
    };
    stored += (c.channel().type == Imf::HALF ? 2 : 4) * (columns / every(c.channel().xSampling)) *
              (rows / every(c.channel().ySampling));
  }
  if (channels < 1 || channels > max_channels) {
    throw InputError(file, "header",
                     "found " + std::to_string(channels) + " channels; allowed: 1 to " +
                         std::to_string(max_channels));
  }
  const std::uintmax_t bytes = channels * sizeof(float) * columns * rows;
  if (bytes > limits::scene_bytes) {
    throw InputError(file, "header",
                     "found " + std::to_string(bytes) + " bytes of pixels; allowed: at most " +
                         std::to_string(limits::scene_bytes));
  }
  const Block block = block_of(header.compression());
  if (stored > free_pixel_bytes && stored / block.best_compression > regular_file_size(file)) {
    throw InputError(file, "header",
                     "found " + sides(columns, rows) + " pixels of " + std::to_string(channels) +
                         (channels == 1 ? " channel" : " channels") +
                         "; the file is too short for them");
  }
  // OpenEXR holds a row of tiles, or a block of rows, of all channels.
  std::uintmax_t block_columns = columns;
  std::uintmax_t block_rows = block.rows;
  if (header.hasTileDescription()) {
    const Imf::TileDescription& tile = header.tileDescription();
    block_columns = std::max<std::uintmax_t>(columns, tile.xSize);
    block_rows = tile.ySize;
    constexpr auto side = static_cast<unsigned>(limits::image_side);
    if (tile.xSize < 1 || tile.ySize < 1 || tile.xSize > side || tile.ySize > side) {
      throw InputError(file, "header",
                       "found tiles of " + sides(tile.xSize, tile.ySize) + "; allowed: 1 to " +
                           std::to_string(side) + " a side");
    }
  }
  if (block_columns * block_rows * channels * sizeof(float) > bytes + free_block_bytes) {
    throw InputError(file, "header",
                     "found blocks of " + sides(block_columns, block_rows) +
                         " pixels in an image of " + sides(columns, rows) +
                         "; allowed: at most 64 MiB more than the image");
  }
}

void check_exr_sampling(const fs::path& file, const Imf::Header& header) {
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    if (c.channel().xSampling == 1 && c.channel().ySampling == 1) continue;
    throw InputError(file, "channel " + quoted_text(c.name()),
                     "found subsampling; allowed: a value for every pixel");
  }
}

}  // namespace brume
