#include "core/io/disk/file_version.h"

#include <gtest/gtest.h>

#include "core/io/disk/alike_file.h"
#include "tests/core/io/folder_test.h"
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

namespace fs = std::filesystem;

using AlikeFile = FolderTest;

// Each name as Linux and Windows store it, and as macOS does.
TEST_F(AlikeFile, ComposedAndDecomposedNamesAreOne) {
  for (const auto& [composed, decomposed] : std::vector<std::pair<std::string, std::string>>{
           {"caf\u00e9.png", "cafe\u0301.png"},
           {"\u00dcber.obj", "U\u0308ber.obj"},
           {"ti\u1ebfng Vi\u1ec7t.png", "tie\u0302\u0301ng Vie\u0323\u0302t.png"},
           {"\u0439.png", "\u0438\u0306.png"},
           {"\u304c\u3071.png", "\u304b\u3099\u306f\u309a.png"},
           {"\ud55c\uae00.png", "\u1112\u1161\u11ab\u1100\u1173\u11af.png"}}) {
    for (const auto& [there, asked] :
         {std::pair(composed, decomposed), std::pair(decomposed, composed)}) {
      const TemporaryFolder folder;
      folder.write(there + "/" + there, "x");
      EXPECT_EQ(find_file_named_alike(folder / (asked + "/" + asked)),
                folder / (there + "/" + there))
          << there;
    }
  }
}

TEST_F(AlikeFile, CaseBlanksAndBackslashesDoNotCount) {
  const fs::path file = folder_.write("Maps/\u00c4pfel ROT.png", "x");
  for (const char* name : {"maps/\u00e4pfel rot.PNG", "Maps\\\u00c4pfel ROT.png",
                           "Maps/\u00c4pfel ROT.png \t", "other\\..\\MAPS\\a\u0308pfel rot.png"}) {
    EXPECT_EQ(find_file_named_alike(folder_ / name), file) << name;
  }
}

TEST_F(AlikeFile, OtherLettersAreOtherFiles) {
  folder_.write("cafe.png", "x");
  for (const char* name :
       {"caf\u00e9.png", "caf.png", "cafe.jpg", "folder/cafe.png", " cafe.png"}) {
    EXPECT_EQ(find_file_named_alike(folder_ / name), folder_ / name);
  }
  EXPECT_EQ(find_file_named_alike(""), "");
}

TEST_F(AlikeFile, TheExactNameComesFirst) {
  const fs::path lower = folder_.write("a.png", "x");
  const fs::path upper = folder_.write("A.png", "x");
  const fs::path blank = folder_.write("A.png ", "x");
  EXPECT_EQ(find_file_named_alike(lower), lower);
  EXPECT_EQ(find_file_named_alike(upper), upper);
  EXPECT_EQ(find_file_named_alike(blank), blank);
  EXPECT_EQ(find_file_named_alike(folder_ / "a.PNG"), upper) << "the same each time";
}

TEST_F(AlikeFile, InvalidBytesAreCompared) {
  const fs::path file = folder_.write("\xe4pfel.png", "x");
  EXPECT_EQ(find_file_named_alike(folder_ / "\xe4pfel.PNG"), file);
  EXPECT_EQ(find_file_named_alike(folder_ / "\xf0"), folder_ / "\xf0");
}

}  // namespace

}  // namespace brume
