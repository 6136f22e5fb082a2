#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/io/scene/scene_document.h"

namespace brume {

// New locations of missing files, by referenced path.
using FoundFiles = std::map<std::filesystem::path, std::filesystem::path>;

// Referenced files that are missing. Paths are absolute; for a sequence, the pattern.
struct MissingFiles {
  FoundFiles found;                            // located elsewhere
  std::vector<std::filesystem::path> missing;  // not located
  // Whether nothing else may be missing than frames of sequences: those are empty, and `missing`
  // names the files of the frames.
  bool only_frames = false;
};

// load_document() that tolerates missing files: reads those in `missing.found` from there and adds
// the others to `missing.missing`. Placeholders: one degenerate triangle, no Gaussians, a black
// environment, a gray material. References are preserved for saving.
SceneDocument load_document(const std::filesystem::path& file, std::vector<std::string>* warnings,
                            MissingFiles& missing);

}  // namespace brume
