#include <gtest/gtest.h>

#include <sys/prctl.h>
#include <sys/wait.h>
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
  expect_interruptible({"export", slow_, "-o", file("o.vdb"), "--voxel", "0.03"}, "sampling ");
  const std::string volume = std::string(BRUME_VOLUMES) + "/smoke_0025.vdb";
  expect_interruptible({"fit", volume, "-o", file("o.ply"), "--count", "100000"}, "fitting ");
  expect_interruptible({"bench", slow_, "-o", file("report")}, "brume: slow");
  write_cloud(200);  // its first pixels take seconds else
  expect_interruptible({"render", slow_, "-o", old, "--airlight", "reference", "--backend", "cpu",
                        "--size", "400x300"},
                       "frame 1 of 1: ");
  EXPECT_EQ(content_of(old), "old");
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

// The program that reads scenes of other programs ends with the one that started it.

namespace fs = std::filesystem;

struct Process {
  std::string name;
  char state = '?';  // 'T': stopped
  pid_t parent = -1;
};

Process process(const std::string& id) {
  const std::string stat = content_of("/proc/" + id + "/stat");
  const std::size_t begin = std::min(stat.size(), stat.find('(') + 1);
  const std::size_t end = std::min(stat.size(), stat.rfind(')') + 1);
  std::istringstream fields(stat.substr(end));
  Process result;
  result.name = stat.substr(begin, end - begin);
  fields >> result.state >> result.parent;
  return result;
}

// The reader that a program has started; -1 if there is none.
pid_t reader_of(pid_t program) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != name.npos) continue;
    const Process found = process(name);
    if (found.parent == program && found.name.starts_with("brume-scene")) return std::stoi(name);
  }
  return -1;
}

bool has_ended(pid_t program, int options = WNOHANG) {
  siginfo_t info{};
  ::waitid(P_PID, static_cast<id_t>(program), &info, WEXITED | WNOWAIT | options);
  return info.si_pid == program;
}

// The reader of a running program, stopped; -1 if it ends before that.
pid_t stopped_reader(pid_t program) {
  pid_t reader = -1;
  while (reader < 0 && !has_ended(program)) reader = reader_of(program);
  if (reader < 0) return -1;
  // Each look sees another moment, and states on the way are many: only these two are last.
  char state = '?';
  while (::kill(reader, SIGSTOP) == 0 && state != 'T' && state != 'Z') {
    state = process(std::to_string(reader)).state;
  }
  return state == 'T' ? reader : -1;
}

class OrphanReader : public CommandLine {
 protected:
  // Orphans become children of this program, which then sees how they end. A terminal that is
  // closed does not end them.
  OrphanReader() : old_(std::signal(SIGHUP, SIG_IGN)) { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }
  ~OrphanReader() override {
    ::prctl(PR_SET_CHILD_SUBREAPER, 0);
    std::signal(SIGHUP, old_);
  }

 private:
  void (*old_)(int);
};

// It is stopped while the signal comes: one that would run on could not have ended before.
TEST_F(OrphanReader, EndsWithTheProgramThatStartedIt) {
  std::string obj;
  for (int i = 0; i < 20'000; ++i)
    obj += "v " + std::to_string(i) + " 0 " + std::to_string(i % 7) + '\n';
  for (int i = 1; i < 19'999; ++i) {
    obj +=
        "f " + std::to_string(i) + ' ' + std::to_string(i + 1) + ' ' + std::to_string(i + 2) + '\n';
  }
  folder_.write("big.obj", obj);
  const std::string scene =
      folder_.write_scene("big.brume", R"("surfaces": [ { "file": "big.obj" } ])");
  pid_t reader = -1;
  while (reader < 0) {
    RunningProgram program({"info", scene});
    reader = stopped_reader(program.pid());
    ::kill(program.pid(), SIGTERM);
    has_ended(program.pid(), 0);
    if (reader > 0) ::kill(reader, SIGCONT);  // else it keeps the terminal open
  }
  int status = 0;
  ASSERT_EQ(::waitpid(reader, &status, 0), reader);
  const bool is_killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  // Its end of the pipe was closed before it asked for the signal.
  const bool has_given_up = WIFEXITED(status) && WEXITSTATUS(status) == EXIT_FAILURE;
  EXPECT_TRUE(is_killed || has_given_up) << status;
}

}  // namespace

}  // namespace brume
