#include "tools/brume/read_scene.h"

#include <vector>

#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"
#include "tools/brume/command.h"
#include "tools/brume/progress_line.h"

namespace brume {
namespace {

SceneDocument load(const std::string& file, std::vector<std::string>& warnings) {
  const ProgressLine line("reading " + file);
  return load_document(file, &warnings);
}

}  // namespace

SceneDocument read_document(const std::string& file, CommandFiles& files) {
  files.add_input(file);
  std::vector<std::string> warnings;
  SceneDocument document = load(file, warnings);
  print_warnings(warnings);
  for (const std::filesystem::path& other : files_of(document)) files.add_input(other);
  return document;
}

Scene read_scene(const std::string& file, CommandFiles& files) {
  return read_document(file, files).scene;
}

}  // namespace brume
