// Captures in which a few splats are none: these are left out, with a warning.

#include "core/io/gaussians/dropped_splats.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/scene/scene_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/gaussians/splat_gltf_builder.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

class DroppedSplatsTest : public FolderTest {
 protected:
  // A capture of `count` splats whose opacities are `opacity` at these places.
  std::filesystem::path capture(int count, const std::vector<int>& places, const char* opacity) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) + "\n";
    for (const char* name : {"x", "y", "z", "opacity", "scale_0"}) {
      text += std::string("property float ") + name + "\n";
    }
    text += "end_header\n";
    for (int i = 0; i < count; ++i) {
      const bool is_bad = std::ranges::find(places, i) != places.end();
      text += std::to_string(i) + " 2 3 " + (is_bad ? opacity : "0") + " -1\n";
    }
    return folder_.write("capture.ply", text);
  }

  std::vector<Gaussian> read(const std::filesystem::path& file) {
    warnings_.clear();
    return read_gaussians(file, nullptr, limits::gaussians, {}, &warnings_);
  }

  std::vector<std::string> warnings_;
};

TEST_F(DroppedSplatsTest, AreCountedWithTheFirstPlace) {
  for (const char* bad : {"nan", "inf"}) {
    const std::vector<Gaussian> found = read(capture(1000, {17, 500}, bad));
    ASSERT_EQ(found.size(), 998u);
    EXPECT_EQ(found[17].center.x, 18.0);
    expect_only(warnings_, "2 of 1000 splats left out; the first: vertex 17: opacity");
  }
  read(capture(10, {}, ""));
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(DroppedSplatsTest, UnknownLinesOfAHeaderAreTold) {
  const auto file = capture(2, {}, "");
  std::string text = content_of(file);
  text.insert(text.find("element"), "Created by hand\n");
  EXPECT_EQ(read(folder_.write("capture.ply", text)).size(), 2u);
  expect_only(warnings_, "line 3: found the unknown keyword Created");
}

TEST_F(DroppedSplatsTest, RefusesFilesInWhichHalfAreBad) {
  EXPECT_EQ(read(capture(5, {0, 1}, "nan")).size(), 3u);
  expect_error([&] { read(capture(4, {1, 3}, "nan")); }, {"vertex 1: opacity", "2 of 4 splats"});
}

TEST_F(DroppedSplatsTest, OfGltfAreLeftOutWhereverNodesPlaceThem) {
  SplatGltfBuilder builder;
  builder.attributes()["POSITION"] = builder.add({1, 2, 3, 4, 5, 6, 7, 8, 9}, "VEC3");
  builder.set("ROTATION", builder.add({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC4"));
  builder.set("SCALE", builder.add({1, 1, 1, 1, -1, 1, 1, 1, 1}, "VEC3"));
  builder.set("OPACITY", builder.add({0.5, 0.5, 0.5}, "SCALAR"));
  builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {10, 0, 0}}});
  builder.json["scenes"][0]["nodes"].push_back(1);
  const std::vector<Gaussian> found = read(folder_.write("a.glb", builder.binary()));
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[1].center, glm::dvec3(7, 8, 9));
  EXPECT_EQ(found[3].center, glm::dvec3(17, 8, 9));
  expect_only(warnings_, "2 of 6 splats left out; the first: nodes[0], splat 1");
}

TEST_F(DroppedSplatsTest, AreAWarningOfTheSceneThatHasTheFile) {
  capture(10, {3}, "nan");
  const auto scene = folder_.write_scene("a.brume", R"("medium": { "file": "capture.ply" })");
  EXPECT_EQ(load_scene(scene, &warnings_).medium.size(), 9u);
  expect_only(warnings_, "medium.file");
  EXPECT_TRUE(contains(warnings_[0], "1 of 10 splats"));
}

TEST_F(DroppedSplatsTest, OfASequenceAreWarningsOfItsScene) {
  const auto file = capture(10, {3}, "nan");
  folder_.write("f_1.ply", content_of(file));
  folder_.write("f_2.ply", content_of(capture(10, {4, 5}, "nan")));
  const auto scene = folder_.write_scene(
      "a.brume", R"("medium": { "sequences": [ { "file": "f_%d.ply", "first": 1, "last": 2 } ] })");
  load_scene(scene, &warnings_);
  ASSERT_EQ(warnings_.size(), 2u);
  EXPECT_TRUE(contains(warnings_[0], "medium.sequences[].file", "f_1.ply: 1 of 10 splats"));
  EXPECT_TRUE(contains(warnings_[1], "f_2.ply: 2 of 10 splats"));
}

// In the file's own names, not in those of the Gaussians that splats become.
TEST_F(DroppedSplatsTest, FaultsHaveTheNamesOfSplats) {
  const SplatNames names{{"x", "y", "z"}, {"scale_0", "scale_1", "scale_2"}, "opacity", {"r"}};
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(splat_fault({{0, 0, 0}, 1, 1}, names), "");
  EXPECT_TRUE(splat_fault({{0, nan, 0}, 1, 1}, names).starts_with("y: found nan"));
  EXPECT_TRUE(splat_fault({{0, 0, 0}, 1e30, 1}, names).starts_with("scale_0: found"));
  EXPECT_TRUE(splat_fault({{0, 0, 0}, 1, nan}, names).starts_with("opacity: "));
}

// Files that are taken for Gaussians: the error says what they are, and what to do with them.

std::string refusal(const TemporaryFolder& folder, const char* name, const std::string& bytes) {
  const auto file = folder.write(name, bytes);
  return error_of([&] { read_gaussians(file); });
}

using OtherFormat = FolderTest;

TEST_F(OtherFormat, CompressedSplatsAreNamedWithTheProgramThatReadsThem) {
  const std::string zeros(64, '\0');
  const std::string packed_ply =
      "ply\nformat binary_little_endian 1.0\nelement chunk 1\nproperty float min_x\n"
      "element vertex 1\nproperty uint packed_position\nproperty uint packed_rotation\n"
      "property uint packed_scale\nproperty uint packed_color\nend_header\n" +
      zeros;
  const std::pair<const char*, std::string> files[] = {
      {"a.spz", "\x1f\x8b\x08" + zeros},
      {"a.spz", "NGSP" + zeros},
      {"a.sog", "PK\x03\x04" + zeros},
      {"a.splat", zeros},
      {"a.ksplat", zeros},
      {"meta.json", R"({"version": 2, "means": {}})"},
      {"a.compressed.ply", packed_ply}};
  for (const auto& [name, bytes] : files) {
    const std::string error = refusal(folder_, name, bytes);
    EXPECT_TRUE(
        contains(error, "has compressed splats", std::string("splat-transform ") + name + " "));
  }
}

TEST_F(OtherFormat, VolumesAndArchivesAreNamed) {
  const std::string zeros(64, '\0');
  const std::string volume = refusal(folder_, "a.vdb", " BDV" + zeros);
  EXPECT_TRUE(contains(volume, "brume fit a.vdb -o a.ply"));
  EXPECT_TRUE(contains(refusal(folder_, "a.ply.gz", "\x1f\x8b\x08" + zeros), "gunzip"));
  EXPECT_TRUE(contains(refusal(folder_, "a.zip", "PK\x03\x04" + zeros), "unzip"));
}

TEST_F(OtherFormat, SplatsThatLackAPropertyAreCalledSplats) {
  const std::string error = refusal(folder_, "a.ply",
                                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                    "property float y\nproperty float z\nproperty float f_dc_0\n"
                                    "property float opacity\nend_header\n0 0 0 0 0\n");
  EXPECT_TRUE(contains(error, "no property scale_0; needed: of splats"));
}

TEST_F(OtherFormat, PointersOfGitLfsAreNamed) {
  const std::string pointer =
      "version https://git-lfs.github.com/spec/v1\noid sha256:0000\nsize 1234567\n";
  for (const char* name : {"a.ply", "a.csv", "a.glb"}) {
    const std::string error = refusal(folder_, name, pointer);
    EXPECT_TRUE(contains(error, "a pointer of Git LFS", "git lfs pull"));
  }
  const auto file = folder_.write("a.any", pointer);
  expect_error([&] { read_bytes(file); }, "Git LFS");
  expect_error([&] { read_first_bytes(file, 2); }, "Git LFS");
  EXPECT_EQ(read_first_bytes(folder_.write("b.any", "version 1"), 4), "vers");
}

}  // namespace

}  // namespace brume
