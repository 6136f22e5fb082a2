#include <filesystem>
#include <string>

#include "core/io/gather.h"
#include "tools/brume/command.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/read_scene.h"

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
    CommandFiles files;
    const Scene scene = read_scene(scene_, files);
    const ProgressLine line("gathering " + scene_);
    if (!gather_scene(scene, folder_, std::filesystem::path(scene_).stem().string(),
                      interruption())) {
      throw Interrupted();
    }
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
