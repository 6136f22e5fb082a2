// Files that are taken for Gaussians: the error says what they are, and what to do with them.

#include <gtest/gtest.h>

#include <utility>

#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

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
    EXPECT_TRUE(contains(error, "has compressed splats"));
    EXPECT_TRUE(contains(error, std::string("splat-transform ") + name + " "));
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
    EXPECT_TRUE(contains(error, "a pointer of Git LFS"));
    EXPECT_TRUE(contains(error, "git lfs pull"));
  }
  const auto file = folder_.write("a.any", pointer);
  expect_error([&] { read_bytes(file); }, "Git LFS");
  expect_error([&] { read_first_bytes(file, 2); }, "Git LFS");
  EXPECT_EQ(read_first_bytes(folder_.write("b.any", "version 1"), 4), "vers");
}

}  // namespace
}  // namespace brume
