// brume-bench: what `brume bench` starts, with the arguments of that, under the name of that
// program.

#include <array>

#include "tools/bench_program/bench_command.h"

int main(int argc, char** argv) {
  using namespace brume;
  const std::filesystem::path brume = argv[0];
  const std::array<Subcommand, 1> commands{{{"bench", bench_description, [&](CLI::App& app) {
                                               return make_bench_command(app, brume);
                                             }}}};
  return run_program(argc, argv, commands);
}
