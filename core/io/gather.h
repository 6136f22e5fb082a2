#pragma once

#include <filesystem>
#include <stop_token>
#include <string>

#include "core/scene/scene.h"

namespace brume {

// Writes a scene as a folder that can go anywhere: `folder`/`name`.brume, and in `folder`/files a
// copy of every file it refers to, each once, under names that differ also where capitals do not
// count. The folder appears when it is complete. It must not exist before, or be empty. Throws
// InputError. Answers false, and leaves nothing, where it was stopped.
bool gather_scene(const Scene& scene, const std::filesystem::path& folder, const std::string& name,
                  const std::stop_token& stop = {});

}  // namespace brume
