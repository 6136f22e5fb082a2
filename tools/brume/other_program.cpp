#include "tools/brume/other_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "tools/brume/command.h"

extern char** environ;

namespace brume {

ProgramOutput run_other_program(const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "a pipe cannot be created");
  }
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) {
    pointers.push_back(const_cast<char*>(argument.c_str()));
  }
  pointers.push_back(nullptr);
  pid_t id = -1;
  const int error = ::posix_spawnp(&id, pointers[0], &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  ProgramOutput result;
  std::array<char, 4096> piece;
  for (ssize_t count = 1; error == 0 && count != 0;) {
    count = ::read(ends[0], piece.data(), piece.size());
    if (count < 0 && errno != EINTR) break;
    if (count > 0) result.out.append(piece.data(), static_cast<std::size_t>(count));
  }
  ::close(ends[0]);
  if (error != 0) {
    throw UsageError("the program " + arguments.front() +
                     " cannot be run: " + std::strerror(error));
  }
  int status = 0;
  while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

}  // namespace brume
