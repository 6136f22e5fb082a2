#include "core/io/disk/file_version.h"

#include <gtest/gtest.h>

#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

TEST(FileVersion, DependsOnTheContent) {
  const TemporaryFolder folder;
  // Around the size of the pieces in which files are read.
  for (const std::size_t size : {0, 1, 7, (1 << 20) - 1, 1 << 20, (1 << 20) + 1, 3 << 20}) {
    SCOPED_TRACE(size);
    const std::string content(size, 'x');
    const auto version = FileVersion::read(folder.write("a", content));
    EXPECT_EQ(version, FileVersion::of_content(content));
    if (size == 0) continue;
    std::string other = content;
    other.back() = 'y';
    EXPECT_NE(version, FileVersion::read(folder.write("a", other)));
  }
}

TEST(FileVersion, IsAbsentForMissingFiles) {
  const TemporaryFolder folder;
  EXPECT_FALSE(FileVersion::read(folder / "missing"));
  EXPECT_FALSE(FileVersion::read(folder.path()));
}

TEST(FileVersion, RoundTripsThroughText) {
  const FileVersion version = FileVersion::of_content("fog");
  EXPECT_EQ(FileVersion::parse(version.text()), version);
  for (const char* text : {"", "-", "3", "3-", "-5", "x-y", "3-5x", "99999999999999999999999-1"}) {
    EXPECT_FALSE(FileVersion::parse(text)) << text;
  }
}

}  // namespace
}  // namespace brume
