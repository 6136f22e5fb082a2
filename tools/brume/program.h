#pragma once

#include <functional>
#include <memory>
#include <span>

#include "tools/brume/command.h"

namespace brume {

// A subcommand by its name, what it does in a few words, and what declares its options.
struct Subcommand {
  const char* name;
  const char* description;
  std::function<std::unique_ptr<Command>(CLI::App&)> make;
};

// `brume` says this of `brume bench`, which is a program of its own.
inline constexpr const char* bench_description = "measure speed against error";

// The main function of a program of such subcommands: parses, runs, and tells errors in a line.
// Returns its exit code.
int run_program(int argc, char** argv, std::span<const Subcommand> commands);

}  // namespace brume
