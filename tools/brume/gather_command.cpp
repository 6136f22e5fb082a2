#include <filesystem>
#include <string>

#include "core/io/scene/gather.h"
#include "tools/brume/command.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/read_scene.h"

namespace brume {
namespace {

class GatherCommand final : public Command {
 public:
  explicit GatherCommand(CLI::App& app) {
    app.add_option("SCENE", scene_, "the scene, .brume")->type_name("FILE")->required();
    app.add_option("FOLDER", folder_, "a new or empty folder")->type_name("FOLDER")->required();
    app.footer("The scene keeps its name; copies of the files it refers to go to FOLDER/files.");
  }

  ExitCode run() override {
    CommandFiles files;
    const SceneDocument document = read_document(scene_, files);
    const ProgressLine line("gathering " + scene_);
    if (!gather_scene(document, folder_, std::filesystem::path(scene_).stem().string(),
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
