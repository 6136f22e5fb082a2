#pragma once

#include <string>
#include <vector>

namespace brume {

struct ProgramOutput {
  int exit_code = 0;  // -1: ended by a signal
  std::string out;    // its standard output
};

// Runs a program, found as a shell finds it, to its end; its errors go to ours. Throws UsageError
// if there is none of that name.
ProgramOutput run_other_program(const std::vector<std::string>& arguments);

}  // namespace brume
