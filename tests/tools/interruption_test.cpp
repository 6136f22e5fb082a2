#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

#include "core/io/gaussians/gaussian_file.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"
#include "tests/tools/running_program.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

// Work that would take many minutes.
class Interruption : public CommandLine {
 protected:
  Interruption() {
    write_cloud(5000);
    slow_ = folder_.write_scene(
        "slow.brume",
        R"("camera": { "eye": [0, 0, 5], "target": [0, 0, 0] }, "film": { "width": 2000, "height": 2000 },
  "medium": { "density": 0.02, "file": "cloud.ply" },
  "lights": [ { "type": "point", "position": [2, 2, 2], "intensity": [30, 20, 10] } ],
  "surfaces": [ { "mesh": "floor.obj" } ])");
  }

  // The fog of the scene.
  void write_cloud(int count) {
    std::vector<Gaussian> gaussians;
    for (int i = 0; i < count; ++i) {
      gaussians.push_back({{std::sin(i), std::sin(7.0 * i), std::sin(31.0 * i)}, 0.4, 0.01});
    }
    write_gaussians(folder_ / "cloud.ply", gaussians);
  }

  // Ctrl-C while `text` is shown ends the program as SIGINT does, and all files are what they were.
  void expect_interruptible(const std::vector<std::string>& arguments, const std::string& text) {
    SCOPED_TRACE(arguments.front() + ", " + text);
    const std::size_t entries = folder_.entry_count();
    RunningProgram program(arguments);
    ASSERT_TRUE(program.wait_for(text)) << program.shown();
    program.press_interrupt();
    const int status = program.wait();
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status << '\n'
                                                                   << program.shown();
    EXPECT_FALSE(contains(program.shown(), "error"));
    EXPECT_EQ(folder_.entry_count(), entries);
  }

  std::string slow_;
};

TEST_F(Interruption, EndsEverySubcommand) {
  const std::string old = folder_.write("old.png", "old");
  expect_interruptible({"render", slow_, "-o", old, "--backend", "cpu"}, "frame 1 of 1: ");
  expect_interruptible({"render", slow_, "-o", old, "--airlight", "reference", "--backend", "cpu"},
                       "frame 1 of 1: ");
  EXPECT_EQ(content_of(old), "old");
  expect_interruptible({"export", slow_, "-o", file("o.vdb"), "--voxel", "0.02"}, "sampling ");
  const std::string volume = std::string(BRUME_VOLUMES) + "/smoke_0025.vdb";
  expect_interruptible({"fit", volume, "-o", file("o.ply"), "--count", "100000"}, "fitting ");
  expect_interruptible({"bench", slow_, "-o", file("report")}, "brume: slow");
}

// The numbers of percent that were shown.
std::set<int> percents(const std::string& shown) {
  std::set<int> all;
  const std::string before = "frame 1 of 1: ";
  for (std::size_t at = shown.find(before); at != std::string::npos;
       at = shown.find(before, at + 1)) {
    all.insert(std::atoi(shown.c_str() + at + before.size()));
  }
  return all;
}

TEST_F(Interruption, AutoTellsItsProgress) {
  RunningProgram program({"render", slow_, "-o", file("o.png"), "--backend", "cpu"});
  while (percents(program.shown()).size() < 4 && program.read()) {
  }
  EXPECT_GE(percents(program.shown()).size(), 4u) << program.shown();
}

// Scripts start so what they put in the background.
TEST_F(Interruption, WorksWhereTheSignalWasIgnored) {
  const auto old = std::signal(SIGINT, SIG_IGN);
  RunningProgram program({"render", slow_, "-o", file("o.png"), "--backend", "cpu"});
  std::signal(SIGINT, old);
  ASSERT_TRUE(program.wait_for("frame 1 of 1: ")) << program.shown();
  ASSERT_EQ(::kill(program.pid(), SIGINT), 0);
  const int status = program.wait();
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
}

// How many threads of a program have worked: others, as libraries keep them, wait from the start.
std::size_t working_threads(pid_t program) {
  std::size_t count = 0;
  std::error_code error;
  const fs::path tasks = "/proc/" + std::to_string(program) + "/task";
  for (fs::directory_iterator task(tasks, error); !error && task != fs::directory_iterator();
       task.increment(error)) {
    const std::string stat = content_of(task->path() / "stat");
    std::istringstream fields(stat.substr(stat.rfind(')') + 1));
    std::string skipped;
    for (int i = 3; i < 14; ++i) fields >> skipped;
    long user = 0;
    long system = 0;
    fields >> user >> system;  // [ticks], of 10 ms or so
    if (user + system > 2) ++count;
  }
  return count;
}

// The measurement of the error too, which is most of the work here.
TEST_F(Interruption, ThreadsBindAllWork) {
  write_cloud(100);  // some seconds: this one is waited for
  RunningProgram program({"render", slow_, "-o", file("o.png"), "--backend", "cpu", "--threads",
                          "1", "--size", "32x24", "--airlight", "sliced", "--stats",
                          file("s.json")});
  std::size_t max_threads = 0;
  for (int i = 0; i < 200 && program.read(); ++i) {
    max_threads = std::max(max_threads, working_threads(program.pid()));
  }
  EXPECT_EQ(max_threads, 1u);
}

}  // namespace
}  // namespace brume
