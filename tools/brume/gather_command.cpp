#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/io/scene/gather.h"
#include "core/io/scene/scene_files.h"
#include "tools/brume/command.h"
#include "tools/brume/command_files.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"

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
    files.make_folder(std::filesystem::absolute(folder_ + "/").parent_path().parent_path());
    const ProgressLine line("gathering " + scene_);
    if (!gather_scene(document, folder_, std::filesystem::path(scene_).stem().string(),
                      interruption())) {
      throw Interrupted();
    }
    tell_of_files_elsewhere(document);
    return done;
  }

 private:
  // Somebody may not mean to hand them on.
  void tell_of_files_elsewhere(const SceneDocument& document) const {
    const std::filesystem::path folder = std::filesystem::absolute(scene_).parent_path();
    const std::vector<std::filesystem::path> files = files_outside(document, folder);
    if (files.empty()) return;
    constexpr std::size_t max_named = 10;
    std::string names;
    for (std::size_t i = 0; i < std::min(files.size(), max_named); ++i) {
      names += (i == 0 ? "" : ", ") + files[i].string();
    }
    if (files.size() > max_named) {
      names += " and " + std::to_string(files.size() - max_named) + " more";
    }
    print_note("copied from outside the scene's folder: " + names);
  }

  std::string scene_;
  std::string folder_;
};

}  // namespace

std::unique_ptr<Command> make_gather_command(CLI::App& app) {
  return std::make_unique<GatherCommand>(app);
}

}  // namespace brume
