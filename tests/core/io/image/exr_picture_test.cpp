#include "core/io/image/exr_picture.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "brume/error.h"
#include "brume/files.h"
#include "core/io/image/deep_exr_file.h"
#include "core/io/image/image_file.h"
#include "core/io/image/radiance_map_file.h"
#include "core/io/image/texture_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

const Imf::Chromaticities acescg({0.713f, 0.293f}, {0.165f, 0.83f}, {0.128f, 0.044f},
                                 {0.32168f, 0.33767f});
const Imf::Chromaticities xyz({1.0f, 0.0f}, {0.0f, 1.0f}, {0.0f, 0.0f}, {1.0f / 3.0f, 1.0f / 3.0f});

using Channels = std::map<std::string, float>;

// A file of one part for each, of 3 x 2 pixels of one colour.
class ExrFiles : public FolderTest {
 protected:
  std::filesystem::path write(const std::vector<Channels>& parts,
                              const Imf::Chromaticities* chromaticities = nullptr,
                              const Imf::Envmap* envmap = nullptr) const {
    std::vector<Imf::Header> headers;
    for (const Channels& channels : parts) {
      Imf::Header header(3, 2);
      header.setType(Imf::SCANLINEIMAGE);
      header.setName("part " + std::to_string(headers.size()));
      for (const auto& [name, value] : channels) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      }
      if (chromaticities != nullptr) Imf::addChromaticities(header, *chromaticities);
      if (envmap != nullptr) Imf::addEnvmap(header, *envmap);
      headers.push_back(header);
    }
    const std::filesystem::path file = folder_ / "a.exr";
    Imf::MultiPartOutputFile output(file.c_str(), headers.data(), static_cast<int>(headers.size()));
    for (std::size_t k = 0; k < parts.size(); ++k) {
      Imf::FrameBuffer frame;
      std::map<std::string, std::vector<float>> pixels;
      for (const auto& [name, value] : parts[k]) {
        pixels[name].assign(3 * 2, value);
        frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels[name].data()),
                                      sizeof(float), 3 * sizeof(float)));
      }
      Imf::OutputPart part(output, static_cast<int>(k));
      part.setFrameBuffer(frame);
      part.writePixels(2);
    }
    return file;
  }

  static glm::vec3 color_of(const std::filesystem::path& file,
                            std::vector<std::string>* warnings = nullptr) {
    ExrPicture picture = read_exr_picture(file, warnings);
    EXPECT_EQ(picture.pixels.size(), 6u);
    picture.convert_to_rec709();
    EXPECT_EQ(picture.pixels.front(), picture.pixels.back());
    return picture.pixels.front();
  }

  static void expect_color(const glm::vec3& found, const glm::vec3& expected) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-5f) << c;
  }
};

Channels rgb(float red, float green, float blue, const std::string& layer = "") {
  return {{layer + "R", red}, {layer + "G", green}, {layer + "B", blue}};
}

// Computed from the definitions of both spaces, by Bradford's transform between their whites.
TEST_F(ExrFiles, ConvertsFromTheirPrimariesAndWhite) {
  expect_color(color_of(write({rgb(0.7947038f, 0.5317338f, 0.2928541f)}, &acescg)),
               {1.0f, 0.5f, 0.25f});
  expect_color(color_of(write({rgb(1.0f, 1.0f, 1.0f)}, &acescg)), glm::vec3(1.0f));
}

// White of Rec. 709, D65, as CIE XYZ has it.
TEST_F(ExrFiles, TristimulusValuesHaveNoWhite) {
  expect_color(color_of(write({rgb(0.9504559f, 1.0f, 1.0890578f)}, &xyz)), glm::vec3(1.0f));
}

TEST_F(ExrFiles, Rec709StaysAsItIs) {
  const glm::vec3 color(0.1f, 65000.0f, -0.3f);
  const Imf::Chromaticities rec709;
  EXPECT_EQ(color_of(write({rgb(color.r, color.g, color.b)})), color);
  EXPECT_EQ(color_of(write({rgb(color.r, color.g, color.b)}, &rec709)), color);
}

TEST_F(ExrFiles, ImpossibleChromaticitiesAreAWarning) {
  const Imath::V2f zero(0.0f, 0.0f);
  for (const Imf::Chromaticities& bad :
       {Imf::Chromaticities(zero, zero, zero, zero), Imf::Chromaticities({nan, 0.33f}),
        Imf::Chromaticities({0.1f, 0.1f}, {0.2f, 0.2f}, {0.3f, 0.3f}),
        Imf::Chromaticities({infinity, 0.33f}),
        Imf::Chromaticities({0.64f, 0.33f}, {0.3f, 0.6f}, {0.15f, 0.06f}, {0.3f, 0.0f}),
        Imf::Chromaticities({0.64f, 0.33f}, {0.3f, 0.6f}, {0.15f, 0.06f}, {0.9f, 0.1f})}) {
    std::vector<std::string> warnings;
    EXPECT_EQ(color_of(write({rgb(1.0f, 0.5f, 0.25f)}, &bad), &warnings),
              glm::vec3(1.0f, 0.5f, 0.25f));
    expect_only(warnings, "a.exr: attribute chromaticities: ");
  }
}

TEST_F(ExrFiles, FindTheirPicture) {
  const glm::vec3 color(1.0f, 0.5f, 0.25f);
  const Channels picture = rgb(1.0f, 0.5f, 0.25f);
  const Channels layer = rgb(1.0f, 0.5f, 0.25f, "beauty.");
  EXPECT_EQ(color_of(write({layer})), color);
  EXPECT_EQ(color_of(write({{{"Z", 3.0f}}, picture})), color) << "in the second part";
  EXPECT_EQ(color_of(write({rgb(9.0f, 9.0f, 9.0f, "albedo."), picture})), color);
  EXPECT_EQ(color_of(write({{{"Z", 3.0f}}, layer})), color);
  EXPECT_EQ(color_of(write({picture, rgb(9.0f, 9.0f, 9.0f)})), color) << "of the first part";
  EXPECT_EQ(color_of(write({{{"Y", 0.5f}, {"A", 1.0f}}})), glm::vec3(0.5f));
  EXPECT_EQ(color_of(write({{{"r", 1.0f}, {"g", 0.5f}, {"b", 0.25f}, {"a.R", 9.0f}}})), color);
  EXPECT_EQ(color_of(write({{{"a.b.red", 1.0f}, {"a.b.green", 0.5f}, {"a.b.blue", 0.25f}}})),
            color);
}

TEST_F(ExrFiles, ListTheirChannelsWithoutAPicture) {
  const auto error = [&](const std::vector<Channels>& parts) {
    const std::filesystem::path file = write(parts);
    return error_of([&] { read_exr_picture(file); });
  };
  EXPECT_TRUE(contains(error({{{"Z", 1.0f}, {"R", 1.0f}}}), "its channels: R Z"));
  Channels layers = rgb(1.0f, 1.0f, 1.0f, "beauty.");
  layers.merge(rgb(1.0f, 1.0f, 1.0f, "albedo."));
  EXPECT_TRUE(contains(error({layers}), "several layers"));
  EXPECT_TRUE(contains(error({{{"Z", 1.0f}}, layers}),
                       "part 1: Z; part 2: albedo.B albedo.G albedo.R beauty.B"));
  EXPECT_TRUE(contains(error({{{"X", 1.0f}, {"Y", 1.0f}, {"Z", 1.0f}}}), "its channels: X Y Z"))
      << "positions are no luminance";
}

TEST_F(ExrFiles, ReadLuminanceAndChroma) {
  constexpr int side = 16;
  const std::filesystem::path file = folder_ / "yc.exr";
  {
    Imf::Header header(side, side);
    Imf::addChromaticities(header, acescg);
    Imf::RgbaOutputFile output(file.c_str(), header, Imf::WRITE_YC);
    const Imf::Rgba pixel(0.7947038f, 0.5317338f, 0.2928541f);
    output.setFrameBuffer(&pixel, 0, 0);
    output.writePixels(side);
  }
  ExrPicture picture = read_exr_picture(file);
  ASSERT_EQ(picture.pixels.size(), static_cast<std::size_t>(side * side));
  picture.convert_to_rec709();
  for (const glm::vec3& pixel : picture.pixels) {
    for (int c = 0; c < 3; ++c) {  // half floats, of which luminance has 7 bits
      EXPECT_NEAR(pixel[c], (glm::vec3(1.0f, 0.5f, 0.25f))[c], 0.01f);
    }
  }
}

TEST_F(ExrFiles, SkiesBecomeFinite) {
  std::vector<std::string> warnings;
  const auto map = [&](const Channels& channels) {
    warnings.clear();
    return read_radiance_map(write({channels}), &warnings)->pixel(1, 1);
  };
  EXPECT_EQ(map(rgb(1.0f, infinity, 2.0f)), glm::vec3(1.0f, 65504.0f, 2.0f));
  expect_only(warnings, "pixel (0, 0): found 6 values from here on");
  EXPECT_EQ(map(rgb(1e6f, infinity, 2.0f)), glm::vec3(1e6f, 1e6f, 2.0f));
  EXPECT_EQ(map(rgb(1.0f, nan, -infinity)), glm::vec3(1.0f, 0.0f, 0.0f));
  EXPECT_EQ(warnings.size(), 1u);
  // Before it is converted: of other primaries infinity would become NaN.
  const glm::vec3 sun =
      read_radiance_map(write({rgb(infinity, infinity, infinity)}, &acescg))->pixel(0, 0);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sun[c], 65504.0f, 1.0f);
}

TEST_F(ExrFiles, WarningsReachWhoReadsAnEnvironmentOrATexture) {
  write({rgb(1.0f, nan, 1.0f)});
  folder_.write_scene("s.brume", R"("surfaces": [
    { "primitive": { "type": "box" }, "material": { "type": "metallic_roughness",
      "base_color_texture": { "file": "a.exr" } } } ])");
  for (const auto& read : std::vector<std::function<void(std::vector<std::string>&)>>{
           [&](auto& warnings) { load_environment(folder_ / "a.exr", &warnings); },
           [&](auto& warnings) { read_texture(folder_ / "a.exr", true, &warnings); },
           [&](auto& warnings) { load_scene(folder_ / "s.brume", &warnings); }}) {
    std::vector<std::string> warnings;
    read(warnings);
    expect_only(warnings, "a.exr: pixel (0, 0): found 6 values");
  }
}

TEST_F(ExrFiles, CubeMapsAreNoSkies) {
  const Imf::Envmap cube = Imf::ENVMAP_CUBE;
  const Imf::Envmap latlong = Imf::ENVMAP_LATLONG;
  EXPECT_NO_THROW(read_radiance_map(write({rgb(1.0f, 1.0f, 1.0f)}, nullptr, &latlong)));
  const std::filesystem::path file = write({rgb(1.0f, 1.0f, 1.0f)}, nullptr, &cube);
  expect_error([&] { read_radiance_map(file); }, "found a cube map");
}

class DeepExr : public FolderTest {
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
