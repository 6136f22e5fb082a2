#include "core/io/frame_pattern.h"

#include <gtest/gtest.h>
#include <atomic>
#include <chrono>
#include <future>
#include <new>

#include "brume/error.h"
#include "core/io/frame_loop.h"
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

constexpr int loop_frames[] = {3, 1, 4, 7};

TEST(FrameLoop, MakesAllAndSkipsWhatIsThere) {
  std::vector<std::string> told;
  std::vector<int> written;
  FrameLoop::Steps steps;
  steps.make = [&](int frame, const std::string& label) -> FrameLoop::Write {
    told.push_back(label);
    if (frame == 7) return {};
    return [&, frame] { written.push_back(frame); };
  };
  steps.skips = [](int frame) { return frame == 1; };
  std::vector<std::size_t> done;
  steps.progressed = [&](std::size_t count, std::size_t of) {
    EXPECT_EQ(of, 4u);
    done.push_back(count);
  };
  const FrameLoop::Result result = FrameLoop::run(loop_frames, steps);
  EXPECT_EQ(result.made, (std::vector{3, 4, 7}));
  EXPECT_EQ(result.skipped, std::vector{1});
  EXPECT_TRUE(result.failed.empty());
  EXPECT_EQ(written, (std::vector{3, 4}));
  EXPECT_EQ(done, (std::vector<std::size_t>{1, 2, 3, 4}));
  ASSERT_EQ(told.size(), 3u);
  EXPECT_EQ(told[0], "frame 3, 1 of 4");
  EXPECT_EQ(told[1], "frame 4, 3 of 4, 0 s left");
}

// Each waits for the other: they would not end one after the other.
TEST(FrameLoop, WritesWhileItMakes) {
  std::promise<void> next_is_made;
  FrameLoop::Steps steps;
  steps.make = [&](int frame, const std::string&) -> FrameLoop::Write {
    if (frame == 1) next_is_made.set_value();
    return [&, frame] {
      if (frame != 3) return;
      const auto waited = next_is_made.get_future().wait_for(std::chrono::seconds(60));
      EXPECT_EQ(waited, std::future_status::ready);
    };
  };
  EXPECT_EQ(FrameLoop::run(loop_frames, steps).made.size(), 4u);
}

TEST(FrameLoop, FailuresLeaveOtherFramesAlone) {
  std::vector<std::string> said;
  FrameLoop::Steps steps;
  steps.make = [&](int frame, const std::string&) -> FrameLoop::Write {
    if (frame == 1) throw InputError("fog_0001.ply", "", "is missing");
    if (frame == 4) throw std::bad_alloc();
    return [frame] {
      if (frame == 3) throw InputError("a.exr", "", "cannot be written: disk full");
    };
  };
  steps.failed = [&](int frame, const std::string& why) {
    said.push_back(std::to_string(frame) + " " + why);
  };
  const FrameLoop::Result result = FrameLoop::run(loop_frames, steps);
  EXPECT_EQ(result.made, std::vector{7});
  EXPECT_EQ(result.failed_frames(), (std::vector{1, 3, 4}));
  EXPECT_EQ(said, (std::vector<std::string>{"1 fog_0001.ply: is missing",
                                            "3 a.exr: cannot be written: disk full",
                                            "4 not enough memory"}));
}

// They end it as Ctrl-C does; but a file that is being written is written.
TEST(FrameLoop, OtherExceptionsEndItWhenFilesAreWritten) {
  struct Stopped {};
  std::atomic<int> written = 0;
  FrameLoop::Steps steps;
  steps.make = [&](int frame, const std::string&) -> FrameLoop::Write {
    if (frame == 1) throw Stopped();
    return [&] { ++written; };
  };
  EXPECT_THROW(FrameLoop::run(loop_frames, steps), Stopped);
  EXPECT_EQ(written, 1);
}

}  // namespace

}  // namespace brume
