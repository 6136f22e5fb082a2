#include "tools/brume/read_scene.h"

#include <utility>

#include "core/io/scene/missing_files.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"
#include "tools/brume/command.h"
#include "tools/brume/progress_line.h"

namespace brume {
namespace {

SceneDocument load(const std::string& file, std::vector<std::string>& warnings,
                   std::vector<std::filesystem::path>* missing) {
  const ProgressLine line("reading " + file);
  if (missing == nullptr) return load_document(file, &warnings);
  MissingFiles files;
  files.only_frames = true;
  SceneDocument document = load_document(file, &warnings, files);
  *missing = std::move(files.missing);
  return document;
}

SceneDocument read_document(const std::string& file, CommandFiles& files,
                            std::vector<std::filesystem::path>* missing) {
  files.add_input(file);
  std::vector<std::string> warnings;
  SceneDocument document = load(file, warnings, missing);
  print_warnings(warnings);
  for (const std::filesystem::path& other : files_of(document)) files.add_input(other);
  return document;
}

}  // namespace

SceneDocument read_document(const std::string& file, CommandFiles& files) {
  return read_document(file, files, nullptr);
}

SceneDocument read_document(const std::string& file, CommandFiles& files,
                            std::vector<std::filesystem::path>& missing) {
  return read_document(file, files, &missing);
}

Scene read_scene(const std::string& file, CommandFiles& files) {
  return read_document(file, files).scene;
}

}  // namespace brume
