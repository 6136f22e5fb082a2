#pragma once

#include <QString>
#include <filesystem>
#include <optional>

#include "core/io/disk/file_version.h"
#include "core/io/scene/missing_files.h"
#include "core/io/scene/scene_document.h"

namespace brume {

struct LoadedScene {
  std::filesystem::path file;  // absolute
  SceneDocument document;
  std::optional<FileVersion> version;  // of the file that was read
  MissingFiles missing;
  QString warnings;  // one a line
};

// Reads a scene file and what it refers to, from the new locations in `found`. Throws InputError.
LoadedScene read_scene(const std::filesystem::path& file, const FoundFiles& found);

}  // namespace brume
