#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/io/installed_files.h"
#include "tools/brume/program.h"

namespace brume {
namespace {

// A program of its own, brume-bench, gets the arguments: who renders need not wait until what
// measures is built. It is named after this program, which it measures.
class BenchCommand final : public Command {
 public:
  explicit BenchCommand(CLI::App& app) : app_(app) {
    app.allow_extras();
    app.set_help_flag();
  }

  ExitCode run() override {
    std::vector<std::string> arguments{std::filesystem::read_symlink("/proc/self/exe").string(),
                                       app_.get_name()};
    for (std::string& argument : app_.remaining()) arguments.push_back(std::move(argument));
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const std::string program = helper_program("brume-bench").string();
    ::execv(program.c_str(), argv.data());
    throw UsageError("the program " + program + " cannot be run: " + std::strerror(errno));
  }

 private:
  CLI::App& app_;
};

}  // namespace
}  // namespace brume

int main(int argc, char** argv) {
  using namespace brume;
  const std::array<Subcommand, 8> commands{{
      {"render", "render a frame of a scene", make_render_command},
      {"compare", "compare two EXR images", make_compare_command},
      {"info", "print what a scene, a medium or a volume contains", make_info_command},
      {"fit", "fit Gaussians to a volume", make_fit_command},
      {"export", "export the medium of a scene for other programs", make_export_command},
      {"gather", "copy a scene and its files into one folder", make_gather_command},
      {"submit", "hand a sequence to a scheduler", make_submit_command},
      {"bench", bench_description,
       [](CLI::App& app) { return std::make_unique<BenchCommand>(app); }},
  }};
  return run_program(argc, argv, commands);
}
