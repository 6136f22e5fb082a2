#pragma once

#include <assimp/scene.h>

#include <filesystem>
#include <vector>

#include "core/io/import/raw_scene.h"

namespace brume {

// Up to two, the first and second texture coordinates of meshes.
using TexcoordChannels = std::vector<unsigned>;

// The materials of a scene as metallic-roughness. Phong's exponent n becomes the roughness whose
// distribution of microfacets is as wide, alpha^2 = 2 / (n + 2) with alpha = roughness^2; what has
// no metalness is a dielectric. A texture of colors takes the place of the color. Returns the
// channels of texture coordinates that the textures of each use.
std::vector<TexcoordChannels> add_materials(const aiScene& from, const std::filesystem::path& file,
                                            RawScene& to);

}  // namespace brume
