#include <filesystem>
#include <string>

#include "core/io/gather.h"
#include "core/io/scene_file.h"
#include "tools/brume/command.h"

namespace brume {
namespace {

class GatherCommand final : public Command {
 public:
  explicit GatherCommand(CLI::App& app) {
    app.add_option("SCENE", scene_, "the scene, .brume")->required();
    app.add_option("FOLDER", folder_, "a folder that is not there yet, or is empty")->required();
    app.footer(
        "FOLDER then has the scene, under its name, and in FOLDER/files a copy of every\n"
        "file it refers to.");
  }

  ExitCode run() override {
    std::vector<std::string> warnings;
    const Scene scene = load_scene(scene_, &warnings);
    print_warnings(warnings);
    gather_scene(scene, folder_, std::filesystem::path(scene_).stem().string());
    return done;
  }

 private:
  std::string scene_;
  std::string folder_;
};

}  // namespace

std::unique_ptr<Command> make_gather_command(CLI::App& app) {
  return std::make_unique<GatherCommand>(app);
}

}  // namespace brume
