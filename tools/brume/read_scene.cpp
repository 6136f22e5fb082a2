#include "tools/brume/read_scene.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/io/frame_pattern.h"
#include "core/io/scene/missing_files.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"
#include "tools/brume/command.h"
#include "tools/brume/progress_line.h"

namespace brume {
namespace {

// Whether a file is one of the frames of a scene's sequences.
bool is_of_sequence(const Scene& scene, const std::filesystem::path& file) {
  return std::ranges::any_of(scene.sequences, [&file](const MediumSequence& sequence) {
    const FramePattern files = *FramePattern::parse(sequence.file.string());
    for (int frame = sequence.first; frame <= sequence.last; ++frame) {
      if (files.file_of(frame) == file) return true;
    }
    return false;
  });
}

SceneDocument load(const std::string& file, std::vector<std::string>& warnings,
                   std::vector<std::filesystem::path>* missing) {
  const ProgressLine line("reading " + file);
  if (missing == nullptr) return load_document(file, &warnings);
  MissingFiles files;
  files.keeps_other_frames = true;
  SceneDocument document = load_document(file, &warnings, files);
  const bool has_rest = std::ranges::all_of(files.missing, [&document](const auto& path) {
    return is_of_sequence(document.scene, path);
  });
  if (!has_rest) return load_document(file);  // which names the place
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
