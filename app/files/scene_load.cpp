#include "app/files/scene_load.h"

#include "app/document/text/words.h"

namespace brume {

LoadedScene read_scene(const std::filesystem::path& file, const FoundFiles& found) {
  LoadedScene loaded;
  loaded.file = std::filesystem::absolute(file);
  std::vector<std::string> warnings;
  // First: a change while the scene is being read is one that it may have missed.
  loaded.version = FileVersion::read(loaded.file);
  loaded.missing.found = found;
  loaded.document = load_document(loaded.file, &warnings, loaded.missing);
  loaded.warnings = lines_of(warnings);
  return loaded;
}

}  // namespace brume
