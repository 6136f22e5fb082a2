#include <gtest/gtest.h>

#include <stdexcept>

#include "brume/error.h"
#include "core/io/image/deep_exr_file.h"
#include "core/io/image/image_file.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

class DeepExr : public ::testing::Test {
 protected:
  // Two rows of three pixels, of 0 to 5 samples, in two pieces.
  void write(const DeepExrHeader& header) const {
    write_deep_exr(file_, header, [&](const TakeDeepRows& take) {
      for (int row = 0; row < 2; ++row) take(rows(row));
    });
  }
  static DeepRows rows(int row) {
    DeepRows rows{row, {}, {}};
    for (unsigned x = 0; x < 3; ++x) {
      rows.counts.push_back(x * (1 + static_cast<unsigned>(row)) + static_cast<unsigned>(row));
      for (unsigned k = 0; k < rows.counts.back(); ++k) {
        const float z = 1.0f + static_cast<float>(k) + 0.1f * static_cast<float>(x);
        rows.samples.push_back({z, z + 0.5f, {z, 2.0f * z, 3.0f * z}, {0.1f, 0.2f, 0.3f}, 0.2f});
      }
    }
    return rows;
  }
  static void expect_same(const DeepSample& a, const DeepSample& b) {
    EXPECT_EQ(a.z, b.z);
    EXPECT_EQ(a.z_back, b.z_back);
    EXPECT_EQ(a.color, b.color);
    EXPECT_EQ(a.alpha, b.alpha);
    EXPECT_EQ(a.mean_alpha, b.mean_alpha);
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "a.deep.exr";
};

TEST_F(DeepExr, KeepsSamplesAndMetadata) {
  write({3, 2, true, {{"brume:scene", "fog.brume"}}});
  DeepExrHeader header;
  const DeepRows read = read_deep_exr(file_, header);
  EXPECT_EQ(header.width, 3);
  EXPECT_EQ(header.height, 2);
  EXPECT_TRUE(header.has_colored_alpha);
  EXPECT_EQ(header.metadata.at("brume:scene"), "fog.brume");
  const DeepRows first = rows(0);
  const DeepRows second = rows(1);
  EXPECT_EQ(read.counts, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 5}));
  ASSERT_EQ(read.samples.size(), first.samples.size() + second.samples.size());
  for (std::size_t i = 0; i < read.samples.size(); ++i) {
    const std::size_t split = first.samples.size();
    expect_same(read.samples[i], i < split ? first.samples[i] : second.samples[i - split]);
  }
}

TEST_F(DeepExr, HasOneAlphaWhereChannelsAgree) {
  write({3, 2, false, {}});
  DeepExrHeader header;
  const DeepRows read = read_deep_exr(file_, header);
  EXPECT_FALSE(header.has_colored_alpha);
  EXPECT_EQ(read.samples[0].alpha, glm::vec3(0.2f));
}

TEST_F(DeepExr, LeavesTheFileWhenProducingFails) {
  write({3, 2, true, {}});
  const std::string before = content_of(file_);
  const auto fail = [](const TakeDeepRows& take) {
    take(rows(0));
    throw std::runtime_error("stopped");
  };
  EXPECT_THROW(write_deep_exr(file_, {3, 2, true, {}}, fail), std::runtime_error);
  EXPECT_EQ(content_of(file_), before);
}

TEST_F(DeepExr, IsNoFlatImage) {
  write({3, 2, true, {}});
  EXPECT_THROW(read_exr(file_), InputError);
  DeepExrHeader header;
  ImageLayers flat{1, 1, {{"R", {1.0f}}}, {}};
  write_exr(file_, flat);
  EXPECT_THROW(read_deep_exr(file_, header), InputError);
}

}  // namespace
}  // namespace brume
