#pragma once

#include <pty.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <vector>

namespace brume {

// The real program on a pseudo-terminal, while it runs.
class RunningProgram {
 public:
  explicit RunningProgram(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), BRUME_PROGRAM);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    winsize size{24, 200, 0, 0};
    pid_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
    if (pid_ < 0) throw std::runtime_error("no terminal");
    if (pid_ == 0) {
      ::execv(argv[0], argv.data());
      ::_exit(127);
    }
  }
  ~RunningProgram() {
    if (!ended_) {
      ::kill(pid_, SIGKILL);
      wait();
    }
    ::close(terminal_);
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  // All that it has shown so far.
  [[nodiscard]] const std::string& shown() const { return shown_; }

  // Reads until `text` is shown; false if the program ends before.
  bool wait_for(const std::string& text) {
    while (shown_.find(text) == std::string::npos) {
      if (!read()) return false;
    }
    return true;
  }

  // Reads the next output; false at the end, which a terminal reports as an error.
  bool read() {
    char bytes[4096];
    const ssize_t count = ::read(terminal_, bytes, sizeof bytes);
    if (count < 0 && errno == EINTR) return true;
    if (count <= 0) return false;
    shown_.append(bytes, static_cast<std::size_t>(count));
    return true;
  }

  // Does what pressing Ctrl-C does.
  void press_interrupt() const {
    const char key = 3;
    if (::write(terminal_, &key, 1) != 1) throw std::runtime_error("the terminal is gone");
  }

  // Reads on until it has ended; its status as of waitpid().
  int wait() {
    while (!ended_ && read()) {
    }
    if (!ended_) {
      ::waitpid(pid_, &status_, 0);
      ended_ = true;
    }
    return status_;
  }

 private:
  pid_t pid_ = -1;
  int terminal_ = -1;
  int status_ = 0;
  bool ended_ = false;
  std::string shown_;
};

}  // namespace brume
