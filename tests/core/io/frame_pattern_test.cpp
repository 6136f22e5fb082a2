#include "core/io/frame_pattern.h"

#include <gtest/gtest.h>

#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

TEST(FramePattern, NamesTheFileOfAFrame) {
  EXPECT_EQ(FramePattern::parse("a/smoke_%04d.vdb")->file_of(12), "a/smoke_0012.vdb");
  EXPECT_EQ(FramePattern::parse("s%d.ply")->file_of(12), "s12.ply");
  EXPECT_EQ(FramePattern::parse("s%02d.ply")->file_of(123), "s123.ply");
  for (const char* text : {"s.ply", "%d_%d.ply", "%s.ply", "%010d.ply"}) {
    EXPECT_FALSE(FramePattern::parse(text)) << text;
  }
}

TEST(FramePattern, CountsInTheNameOnly) {
  EXPECT_EQ(FramePattern::parse("50%density/a_%d.png")->file_of(3), "50%density/a_3.png");
  EXPECT_EQ(FramePattern::parse("%d/%%/a_%d.png")->file_of(3), "%d/%%/a_3.png");
  for (const char* text : {"50%density/a.png", "%d/a.png", "%d/"}) {
    EXPECT_FALSE(FramePattern::is_pattern(text)) << text;
    EXPECT_FALSE(FramePattern::parse(text)) << text;
  }
}

TEST(FramePattern, TwoPercentsAreOne) {
  const auto pattern = FramePattern::parse("100%%/100%%_%%d_%02d%%.png");
  ASSERT_TRUE(pattern);
  EXPECT_EQ(pattern->file_of(3), "100%%/100%_%d_03%.png");
  EXPECT_EQ(pattern->text(), "100%%/100%%_%%d_%02d%%.png");
  EXPECT_EQ(pattern->printf_text(), "100%%%%/100%%_%%d_%02d%%.png");
  EXPECT_EQ(FramePattern::parse("%x_%d%.png")->file_of(3), "%x_3%.png");
  EXPECT_FALSE(FramePattern::is_pattern("%%d.png"));
}

TEST(FramePattern, IsFoundWhereNamesHavePercents) {
  const TemporaryFolder folder;
  for (const char* name : {"5%d/100%_%d_1.ply", "5%d/100%_%d_2.ply"}) folder.write(name, "");
  const auto pattern = FramePattern::around((folder / "5%d/100%_%d_2.ply").string());
  ASSERT_TRUE(pattern);
  EXPECT_EQ(pattern->frames(), (std::vector{1, 2}));
  EXPECT_EQ(pattern->file_of(2), (folder / "5%d/100%_%d_2.ply").string());
  EXPECT_EQ(FramePattern::parse(pattern->text())->file_of(2), pattern->file_of(2));
}

TEST(FramePattern, IsFoundFromOneOfItsFiles) {
  const TemporaryFolder folder;
  for (const char* name : {"smoke_0011.vdb", "smoke_0012.vdb", "smoke_0100.vdb", "smoke_013.vdb",
                           "smoke_0014.ply", "a9.ply", "a10.ply", "alone1.ply", "none.ply"}) {
    folder.write(name, "");
  }
  const auto around = [&](const char* name) {
    return FramePattern::around((folder / name).string());
  };
  const auto smoke = around("smoke_0012.vdb");
  ASSERT_TRUE(smoke);
  EXPECT_EQ(smoke->text(), (folder / "smoke_%04d.vdb").string());
  EXPECT_EQ(smoke->frames(), (std::vector{11, 12, 100}));
  EXPECT_EQ(around("a9.ply")->frames(), (std::vector{9, 10}));
  EXPECT_FALSE(around("alone1.ply"));
  EXPECT_FALSE(around("none.ply"));
  EXPECT_TRUE(FramePattern::parse((folder / "nowhere/%d.ply").string())->frames().empty());
}

}  // namespace
}  // namespace brume
