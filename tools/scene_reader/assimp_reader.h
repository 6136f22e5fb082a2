#pragma once

#include <filesystem>

#include "core/io/import/raw_scene.h"

namespace brume {

// Reads an OBJ with its MTL, or an FBX, by assimp: triangles, materials as metallic-roughness,
// cameras and lights. Throws InputError. The library may crash or hang on a hostile file.
RawScene read_with_assimp(const std::filesystem::path& file);

}  // namespace brume
