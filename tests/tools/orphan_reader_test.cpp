// The program that reads scenes of other programs ends with the one that started it.

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <sstream>

#include "tests/tools/command_line.h"
#include "tests/tools/running_program.h"

namespace brume {
namespace {

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
