#include "core/io/disk/alike_file.h"

#include <gtest/gtest.h>

#include "tests/core/io/folder_test.h"

namespace brume {
namespace {

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
