#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/core/io/temporary_folder.h"

namespace brume {

struct ProgramResult {
  int exit_code = -1;  // or -1 if it did not exit by itself
  std::string out;
  std::string err;
};

// Differences from a plain run.
struct ProgramRun {
  std::string before{};  // shell commands that prepare it
  std::string out{};     // a file that exists, for standard output
};

inline std::string quoted(const std::string& argument) {
  std::string text = "'";
  for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

// Runs the real program and waits for it.
inline ProgramResult run_brume(const std::vector<std::string>& arguments,
                               const ProgramRun& run = {}) {
  const TemporaryFolder folder;
  std::string command = run.before + quoted(BRUME_PROGRAM);
  for (const std::string& argument : arguments) (command += ' ') += quoted(argument);
  command += " >" + quoted(run.out.empty() ? (folder / "out").string() : run.out);
  command += " 2>" + quoted((folder / "err").string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(folder / "out"),
          content_of(folder / "err")};
}

}  // namespace brume
