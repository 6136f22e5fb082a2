#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/scene/imported_scene.h"

namespace brume {

// Whether a file has the extension of a scene that read_imported_scene() reads: .gltf, .glb, .obj,
// .fbx.
bool is_imported_scene(const std::filesystem::path& file);

// Reads a glTF, OBJ or FBX scene with its textures. Warnings, one line each (missing textures, what
// is left out), are appended to `warnings`. Null when stopped. Throws InputError naming the file
// and what is wrong with it.
std::shared_ptr<const ImportedScene> read_imported_scene(const std::filesystem::path& file,
                                                         std::vector<std::string>& warnings,
                                                         const std::stop_token& stop = {});

// When the latest of these files was changed; missing ones do not count.
std::filesystem::file_time_type latest_change(std::span<const std::filesystem::path> files);

// Whether an OBJ names material files: else it is a mesh and nothing more.
bool obj_has_materials(const std::filesystem::path& file);

}  // namespace brume
