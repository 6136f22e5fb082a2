#pragma once

#include <filesystem>
#include <stop_token>
#include <string>

#include "core/io/scene/scene_document.h"

namespace brume {

// Writes a scene as a relocatable folder: `folder`/`name`.brume, and in `folder`/files a copy of
// every referenced file, once each, under names that are unique ignoring case. The folder appears
// when complete; it must be missing or empty before. Throws InputError. False, leaving nothing, if
// stopped.
bool gather_scene(const SceneDocument& document, const std::filesystem::path& folder,
                  const std::string& name, const std::stop_token& stop = {});

}  // namespace brume
