#include "core/io/frame_loop.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <new>

#include "brume/error.h"

namespace brume {
namespace {

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
