#include "core/io/import/reader_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/disk/installed_files.h"
#include "core/io/import/raw_scene_bytes.h"

extern char** environ;

namespace brume {
namespace fs = std::filesystem;
namespace {

// A text of numbers becomes objects of a library, and those a mesh.
constexpr std::uintmax_t memory_per_byte = 64;
constexpr std::uintmax_t min_memory = std::uintmax_t{512} << 20;
constexpr std::uintmax_t bytes_per_second = 1'000'000;
constexpr std::uintmax_t min_seconds = 30;

constexpr int poll_time = 50;  // [ms]

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }
  [[nodiscard]] int number() const { return fd_; }

 private:
  int fd_;
};

// A running program whose standard output is read. Ends it when destroyed.
class Child {
 public:
  Child(const fs::path& file, const std::vector<std::string>& arguments) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw InputError(file, "", std::string("cannot be read: ") + std::strerror(errno));
    }
    output_.emplace(ends[0]);
    Descriptor input(ends[1]);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, input.number(), STDOUT_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) {
      pointers.push_back(const_cast<char*>(argument.c_str()));
    }
    pointers.push_back(nullptr);
    const int error = ::posix_spawn(&id_, pointers[0], &actions, nullptr, pointers.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
      id_ = -1;
      throw InputError(
          file, "", "the program " + arguments.front() + " cannot be run: " + std::strerror(error));
    }
  }
  ~Child() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // All that it writes, up to `longest` bytes; less when stopped.
  std::string read(std::size_t longest, const std::stop_token& stop) {
    std::string bytes;
    std::array<char, 1 << 16> piece;
    while (!stop.stop_requested() && bytes.size() <= longest) {
      pollfd waiting{output_->number(), POLLIN, 0};
      const int ready = ::poll(&waiting, 1, poll_time);
      if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
      const ssize_t count = ::read(output_->number(), piece.data(), piece.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) break;
      bytes.append(piece.data(), static_cast<std::size_t>(count));
    }
    return bytes;
  }

  // Its exit code once it has ended; -1 if a signal ended it.
  int wait() {
    output_.reset();  // if it still writes, it ends
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t id_ = -1;
  std::optional<Descriptor> output_;
};

}  // namespace

RawScene read_by_program(const fs::path& file, const std::stop_token& stop) {
  const std::uintmax_t size = regular_file_size(file);
  if (size > limits::file_bytes) {
    throw InputError(file, "",
                     "has " + std::to_string(size) + " bytes; allowed: at most " +
                         std::to_string(limits::file_bytes));
  }
  const std::uintmax_t memory =
      std::min<std::uintmax_t>(min_memory + memory_per_byte * size, limits::scene_bytes);
  const std::uintmax_t seconds = min_seconds + size / bytes_per_second;
  Child child(file, {helper_program("brume-scene-reader").string(), file.string(),
                     std::to_string(memory), std::to_string(seconds)});
  const std::string output = child.read(memory, stop);
  if (stop.stop_requested()) return {};
  const int code = child.wait();
  if (code == 0) return read_raw_scene(file, output);
  if (code == 2 && output.size() < 4096) {
    const std::string name = file.string() + ": ";
    throw InputError(file, "", output.starts_with(name) ? output.substr(name.size()) : output);
  }
  throw InputError(file, "",
                   "cannot be read: it is damaged or exceeds the limit for its size, " +
                       std::to_string(memory >> 20) + " MiB of memory or " +
                       std::to_string(seconds) + " s");
}

}  // namespace brume
