#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/io/disk/installed_files.h"
#include "tools/brume/program.h"

namespace brume {
namespace {

// `brume bench` is a program of its own, brume-bench: who renders need not wait until what measures
// is built. It gets the arguments as they are, under the name of this program, which it measures.
[[noreturn]] void become_bench(char** argv) {
  const std::string program = helper_program("brume-bench").string();
  std::string own_file = std::filesystem::read_symlink("/proc/self/exe").string();
  argv[0] = own_file.data();
  ::execv(program.c_str(), argv);
  throw UsageError("the program " + program + " cannot be run: " + std::strerror(errno));
}

// For --help alone.
class BenchCommand final : public Command {
 public:
  ExitCode run() override { return bad_input; }
};

}  // namespace
}  // namespace brume

int main(int argc, char** argv) {
  using namespace brume;
  try {
    if (argc > 1 && std::string_view(argv[1]) == "bench") become_bench(argv);
  } catch (const UsageError& error) {
    print_note(std::string("error: ") + error.what());
    return bad_input;
  }
  const std::array<Subcommand, 8> commands{{
      {"render", "render a frame of a scene", make_render_command},
      {"compare", "compare two EXR images", make_compare_command},
      {"info", "print what a scene, a medium or a volume contains", make_info_command},
      {"fit", "fit Gaussians to a volume", make_fit_command},
      {"export", "export the medium of a scene for other programs", make_export_command},
      {"gather", "copy a scene and its files into one folder", make_gather_command},
      {"submit", "hand a sequence to a scheduler", make_submit_command},
      {"bench", bench_description, [](CLI::App&) { return std::make_unique<BenchCommand>(); }},
  }};
  return run_program(argc, argv, commands);
}
