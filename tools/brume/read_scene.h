#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/scene/scene_document.h"
#include "tools/brume/command_files.h"

namespace brume {

// Loads the scene of a command, whose other files become inputs of it; prints what there is to warn
// of. Throws InputError.
SceneDocument read_document(const std::string& file, CommandFiles& files);
// The same where only files of some frames of sequences may be missing, which are appended to
// `missing`.
SceneDocument read_document(const std::string& file, CommandFiles& files,
                            std::vector<std::filesystem::path>& missing);
// The scene of it alone.
Scene read_scene(const std::string& file, CommandFiles& files);

}  // namespace brume
