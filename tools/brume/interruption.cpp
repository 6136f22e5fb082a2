#include "tools/brume/interruption.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <thread>

namespace brume {
namespace {

constexpr int shell_code = 130;  // 128 + SIGINT
constexpr char interrupt = 'i';
constexpr char end = 'e';

std::stop_source source;
struct sigaction previous;
std::array<int, 2> ends{-1, -1};  // of the pipe from the handler to the thread
std::thread watcher;

void send(char message) {
  while (::write(ends[1], &message, 1) < 0 && errno == EINTR) {
  }
}

// Does only what a handler may.
void on_interrupt(int) {
  const int error = errno;
  ::sigaction(SIGINT, &previous, nullptr);
  send(interrupt);
  errno = error;
}

// Whether a message arrives within `milliseconds`; -1: no limit.
bool receive(char& message, int milliseconds) {
  for (;;) {
    pollfd watched{ends[0], POLLIN, 0};
    const int ready = ::poll(&watched, 1, milliseconds);
    if (ready < 0 && errno == EINTR) continue;
    return ready > 0 && ::read(ends[0], &message, 1) == 1;
  }
}

// A ProgressLine will not get to it.
void clear_progress() {
  constexpr std::string_view clear = "\r\033[K";
  if (::isatty(STDERR_FILENO) == 0) return;
  if (::write(STDERR_FILENO, clear.data(), clear.size()) < 0) return;
}

void watch() {
  constexpr int patience = 500;  // [ms]
  char message = end;
  if (!receive(message, -1) || message == end) return;
  source.request_stop();
  if (receive(message, patience)) return;
  clear_progress();
  ::kill(::getpid(), SIGINT);  // now what it was before
  if (receive(message, patience)) return;
  ::_exit(shell_code);
}

}  // namespace

std::stop_token interruption() {
  return source.get_token();
}

void check_interrupted() {
  if (source.stop_requested()) throw Interrupted();
}

InterruptionWatch::InterruptionWatch() {
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "a pipe cannot be created");
  }
  watcher = std::thread(watch);
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGINT, &action, &previous);
  // Shell scripts start background jobs with SIGINT ignored; handle it nevertheless, since sending
  // one is deliberate.
  if (previous.sa_handler == SIG_IGN) previous.sa_handler = SIG_DFL;
}

InterruptionWatch::~InterruptionWatch() {
  send(end);
  watcher.join();
  ::sigaction(SIGINT, &previous, nullptr);
  for (const int fd : ends) ::close(fd);
}

void end_interrupted() {
  ::raise(SIGINT);  // which is again what it was before
  ::_exit(shell_code);
}

}  // namespace brume
