#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace brume {

// The scene file, version 1 (JSON, extension .brume).

// Loads a scene with everything it refers to (meshes, Gaussian files) and checks all of it.
// Throws InputError naming file, JSON path, what was found and what is allowed. Warnings (one
// line each: unknown keys, keys without effect yet) are appended to `warnings` if given.
Scene load_scene(const std::filesystem::path& file, std::vector<std::string>* warnings = nullptr);

// Writes a scene so that loading it gives the same scene back; references become relative to the
// new file where they can. An existing file is replaced only by a complete one. Throws InputError.
void save_scene(const Scene& scene, const std::filesystem::path& file);

// Whether a saved scene refers to its medium_file: while that one's Gaussians are what they were.
bool refers_to_medium_file(const Scene& scene);

// The text save_scene writes to a file in `directory`.
std::string scene_to_json(const Scene& scene, const std::filesystem::path& directory);

}  // namespace brume
