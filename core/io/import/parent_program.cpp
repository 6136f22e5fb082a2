#include "core/io/import/parent_program.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

namespace brume {

namespace {

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

// The libraries take this much of the address space.
rlim_t address_space() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

void limit_to_parent(std::uint64_t max_bytes, std::uint64_t max_seconds) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // One that has ended before sends no signal, but has closed its end of the pipe.
  pollfd output{STDOUT_FILENO, 0, 0};
  if (::poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0) std::_Exit(EXIT_FAILURE);
  limit(RLIMIT_AS, address_space() + max_bytes);
  limit(RLIMIT_CPU, max_seconds);
  limit(RLIMIT_CORE, 0);
}

}  // namespace brume
