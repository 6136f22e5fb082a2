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
