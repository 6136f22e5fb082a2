#include "core/io/import/parent_program.h"

#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace brume {

void end_with_parent() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // One that has ended before sends no signal, but has closed its end of the pipe.
  pollfd output{STDOUT_FILENO, 0, 0};
  if (::poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0) std::_Exit(EXIT_FAILURE);
}

}  // namespace brume
