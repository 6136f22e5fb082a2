#include "core/io/image/deep_exr_file.h"

#include <IexBaseExc.h>
#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineInputFile.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfHeader.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>

#include <cassert>
#include <cstddef>

#include "brume/error.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/image/exr_writing.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

struct DeepChannel {
  const char* name;
  std::size_t offset;  // of its float in a DeepSample
  bool is_colored_alpha;
};

constexpr std::size_t color_at = offsetof(DeepSample, color);
constexpr std::size_t alpha_at = offsetof(DeepSample, alpha);
constexpr DeepChannel deep_channels[] = {
    {"R", color_at, false},
    {"G", color_at + sizeof(float), false},
    {"B", color_at + 2 * sizeof(float), false},
    {"A", offsetof(DeepSample, mean_alpha), false},
    {"AR", alpha_at, true},
    {"AG", alpha_at + sizeof(float), true},
    {"AB", alpha_at + 2 * sizeof(float), true},
    {"Z", offsetof(DeepSample, z), false},
    {"ZBack", offsetof(DeepSample, z_back), false},
};

// The buffer that OpenEXR reads rows from, or writes them to: it wants a pointer per pixel and
// channel.
class DeepBuffer {
 public:
  DeepBuffer(int width, int first, bool has_colored_alpha, DeepRows& rows) : rows_(rows) {
    // Where row 0 would be.
    const std::ptrdiff_t origin = -static_cast<std::ptrdiff_t>(first) * width;
    const auto row = static_cast<std::size_t>(width);
    buffer_.insertSampleCountSlice(Imf::Slice(Imf::UINT,
                                              reinterpret_cast<char*>(rows.counts.data() + origin),
                                              sizeof(std::uint32_t), sizeof(std::uint32_t) * row));
    std::size_t used = 0;
    for (const DeepChannel& channel : deep_channels) {
      if (channel.is_colored_alpha && !has_colored_alpha) continue;
      pointers_[used].resize(rows.counts.size());
      buffer_.insert(
          channel.name,
          Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers_[used].data() + origin),
                         sizeof(char*), sizeof(char*) * row, sizeof(DeepSample)));
      offsets_[used++] = channel.offset;
    }
    used_ = used;
  }
  [[nodiscard]] const Imf::DeepFrameBuffer& buffer() const { return buffer_; }
  // Where each pixel's samples are, by its counts.
  void point_to_samples() {
    char* sample = reinterpret_cast<char*>(rows_.samples.data());
    for (std::size_t i = 0; i < rows_.counts.size(); ++i) {
      for (std::size_t c = 0; c < used_; ++c) pointers_[c][i] = sample + offsets_[c];
      sample += sizeof(DeepSample) * rows_.counts[i];
    }
  }

 private:
  DeepRows& rows_;
  Imf::DeepFrameBuffer buffer_;
  std::vector<char*> pointers_[std::size(deep_channels)];
  std::size_t offsets_[std::size(deep_channels)] = {};
  std::size_t used_ = 0;
};

void write_rows(const fs::path& file, std::ostream& out, const DeepExrHeader& image,
                const std::function<void(const TakeDeepRows& take)>& produce) {
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIPS_COMPRESSION;
  header.setType(Imf::DEEPSCANLINE);
  for (const DeepChannel& channel : deep_channels) {
    if (channel.is_colored_alpha && !image.has_colored_alpha) continue;
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
  }
  add_attributes(image.metadata, image.view, header);
  ExrOutput stream(file, out);
  Imf::DeepScanLineOutputFile output(stream, header);
  produce([&](const DeepRows& rows) {
    // OpenEXR only reads from it.
    auto& source = const_cast<DeepRows&>(rows);
    const auto count = static_cast<int>(rows.counts.size() / static_cast<std::size_t>(image.width));
    assert(output.currentScanLine() == rows.first && rows.first + count <= image.height);
    DeepBuffer buffer(image.width, rows.first, image.has_colored_alpha, source);
    buffer.point_to_samples();
    output.setFrameBuffer(buffer.buffer());
    output.writePixels(count);
  });
  assert(output.currentScanLine() == image.height);
}

}  // namespace

void write_deep_exr(const fs::path& file, const DeepExrHeader& header,
                    const std::function<void(const TakeDeepRows& take)>& produce) {
  write_atomically(file, [&](std::ostream& out) {
    try {
      write_rows(file, out, header, produce);
    } catch (const Iex::BaseExc& error) {
      throw InputError(file, "", std::string("cannot be written: ") + error.what());
    }
  });
}

DeepRows read_deep_exr(const fs::path& file, DeepExrHeader& image) {
  regular_file_size(file);
  try {
    Imf::DeepScanLineInputFile input(file.c_str());
    const Imf::Header& header = input.header();
    const Imath::Box2i& window = header.dataWindow();
    image.width = window.max.x - window.min.x + 1;
    image.height = window.max.y - window.min.y + 1;
    image.has_colored_alpha = header.channels().findChannel("AR") != nullptr;
    for (auto a = header.begin(); a != header.end(); ++a) {
      const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute());
      if (text != nullptr) image.metadata[a.name()] = text->value();
    }
    DeepRows rows;
    rows.counts.resize(static_cast<std::size_t>(image.width) *
                       static_cast<std::size_t>(image.height));
    DeepBuffer buffer(image.width, 0, image.has_colored_alpha, rows);
    input.setFrameBuffer(buffer.buffer());
    input.readPixelSampleCounts(window.min.y, window.max.y);
    std::size_t samples = 0;
    for (const std::uint32_t count : rows.counts) samples += count;
    rows.samples.resize(samples);
    buffer.point_to_samples();
    input.readPixels(window.min.y, window.max.y);
    for (DeepSample& sample : rows.samples) {
      if (!image.has_colored_alpha) sample.alpha = glm::vec3(sample.mean_alpha);
    }
    return rows;
  } catch (const Iex::BaseExc& error) {
    throw InputError(file, "", "not a readable deep image: " + quoted_text(error.what(), 200));
  }
}

}  // namespace brume
