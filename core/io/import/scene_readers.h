#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "brume/limits.h"
#include "core/io/import/raw_scene.h"

namespace brume {

// Reads a glTF 2.0 scene (.gltf, .glb) of its default scene: triangles, skinned and morphed as
// at 0 s, metallic-roughness materials, cameras, KHR_lights_punctual. What it has besides is
// left out, with a warning where it would be seen. Throws InputError naming the JSON path.
RawScene read_gltf(const std::filesystem::path& file);

// Luminous efficacy of the light of imported scenes, whose photometric units become radiometric
// ones by it: candela W/sr, lux W/u^2. Blender's value, to and from glTF.
inline constexpr double lumens_per_watt = 683.0;

// A name from a file as scenes of Brume may have it: without control characters, up to
// limits::name_length bytes; `otherwise` if nothing is left.
std::string imported_name(std::string_view name, const std::string& otherwise);

}  // namespace brume
