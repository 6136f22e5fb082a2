#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace brume {

// The scene file, version 1 (JSON, extension .brume).

// Loads a scene with all referenced files and validates it. Throws InputError naming file, JSON
// path, the value found and the allowed ones. Warnings (one line each: unknown keys, keys without
// effect) are appended to `warnings` if given.
Scene load_scene(const std::filesystem::path& file, std::vector<std::string>* warnings = nullptr);

// Writes a scene losslessly; references become relative to the new file if possible. Atomic. Throws
// InputError.
void save_scene(const Scene& scene, const std::filesystem::path& file);

// Whether a saved scene refers to its medium_file: as long as its Gaussians are unchanged.
bool refers_to_medium_file(const Scene& scene);

// The text that save_scene() writes to a file in `directory`.
std::string scene_to_json(const Scene& scene, const std::filesystem::path& directory);

}  // namespace brume
