
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "brume/error.h"
#include "core/io/gaussians/sequence_file.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

SequenceFrame frame_of(std::size_t index, std::size_t count) {
  SequenceFrame frame;
  for (std::size_t i = 0; i < count; ++i) {
    frame.ids.push_back(static_cast<GaussianNumber>(i));
    frame.gaussians.push_back({{static_cast<double>(index), 0.0, 0.0}, 1.0, 1.0});
  }
  return frame;
}

// Waits: how long a thread takes is any length.
template <class Condition>
void wait_for(Condition condition) {
  while (!condition()) std::this_thread::yield();
}

TEST(SequenceReader, ReadsAheadWithinItsBudget) {
  std::atomic<int> read = 0;
  const SequenceReader frames(
      std::vector<std::size_t>(40, 10),
      [&](std::size_t index) {
        ++read;
        return frame_of(index, 10);
      },
      100);
  EXPECT_EQ(frames.size(), 40u);
  EXPECT_EQ(frames.max_gaussians(), 20u);
  EXPECT_FALSE(frames.are_in_memory());
  EXPECT_EQ(read, 0) << "nothing has been asked for";
  EXPECT_EQ(*frames.frame(3), frame_of(3, 10));
  wait_for([&] { return frames.kept() == (std::vector<std::size_t>{3, 4, 5, 6, 7}); });
  // Those that are there are not read again, and more come.
  EXPECT_EQ(*frames.frame(4), frame_of(4, 10));
  wait_for([&] { return frames.kept().back() == 8; });
  EXPECT_EQ(read, 6);
  // In order, and from the start again.
  for (std::size_t round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_EQ(*frames.frame(i), frame_of(i, 10));
      EXPECT_LE(frames.kept().size(), 11u);
    }
  }
}

TEST(SequenceReader, TwoFramesAreKeptHoweverLarge) {
  const SequenceReader frames(
      {50, 70, 60}, [](std::size_t index) { return frame_of(index, 50); }, 10);
  EXPECT_EQ(frames.max_gaussians(), 130u);
  for (const std::size_t i : {0, 1, 2, 0}) EXPECT_EQ(*frames.frame(i), frame_of(i, 50));
}

// Each time one asks for it, and not before.
TEST(SequenceReader, SaysWhatCannotBeRead) {
  const SequenceReader frames({1, 1, 1}, [](std::size_t index) {
    if (index == 1) throw InputError("f_1.ply", "", "is missing");
    return frame_of(index, 1);
  });
  EXPECT_EQ(*frames.frame(0), frame_of(0, 1));
  wait_for([&] { return frames.kept() == (std::vector<std::size_t>{0, 2}); });
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(error_of([&] { static_cast<void>(frames.frame(1)); }), "f_1.ply: is missing");
  }
  EXPECT_EQ(*frames.frame(2), frame_of(2, 1));
}

TEST(SequenceReader, ServesManyThreads) {
  const SequenceReader frames(
      std::vector<std::size_t>(20, 10), [](std::size_t index) { return frame_of(index, 10); }, 60);
  std::vector<std::jthread> threads;
  for (std::size_t t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = 0; i < 200; ++i) {
        const std::size_t index = (i * (t + 1) + 7 * t) % frames.size();
        EXPECT_EQ(*frames.frame(index), frame_of(index, 10));
      }
    });
  }
}

TEST(OpenSequence, ReadsLargeOnesWhenTheyAreNeeded) {
  const TemporaryFolder folder;
  for (int number = 0; number < 4; ++number) {
    const SequenceFrame frame = frame_of(static_cast<std::size_t>(number), 5);
    write_gaussians(folder / ("f_" + std::to_string(number) + ".ply").c_str(), frame.gaussians,
                    frame.ids);
  }
  const auto files = FramePattern::parse((folder / "f_%d.ply").string());
  const auto whole = open_sequence(*files, 0, 3);
  EXPECT_TRUE(whole->are_in_memory());
  const auto lazy =
      open_sequence(*files, 0, 3, read_gaussian_frame, limits::gaussians, nullptr, 10);
  EXPECT_FALSE(lazy->are_in_memory());
  EXPECT_EQ(lazy->max_gaussians(), whole->max_gaussians());
  MediumSequence a{.file = files->text(), .first = 0, .last = 3, .frames = whole};
  MediumSequence b = a;
  b.frames = lazy;
  for (const double time : {0.0, 0.05, 0.09, 1.0}) {
    EXPECT_EQ(sequence_at(a, time, glm::dvec3(1.0)), sequence_at(b, time, glm::dvec3(1.0)));
  }
  // Missing frames are known when it is opened, as with small ones.
  expect_error([&] { open_sequence(*files, 0, 4, read_gaussian_frame, 1000, nullptr, 10); },
               "f_4.ply");
}

}  // namespace
}  // namespace brume
