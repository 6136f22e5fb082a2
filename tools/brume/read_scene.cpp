#include "tools/brume/read_scene.h"

#include <vector>

#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"
#include "tools/brume/command.h"
#include "tools/brume/progress_line.h"

namespace brume {
namespace {

Scene load(const std::string& file, std::vector<std::string>& warnings) {
  const ProgressLine line("reading " + file);
  return load_scene(file, &warnings);
}

}  // namespace

Scene read_scene(const std::string& file, CommandFiles& files) {
  files.add_input(file);
  std::vector<std::string> warnings;
  Scene scene = load(file, warnings);
  print_warnings(warnings);
  for (const std::filesystem::path& other : files_of(scene)) files.add_input(other);
  return scene;
}

}  // namespace brume
