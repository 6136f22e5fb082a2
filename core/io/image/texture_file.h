#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "brume/limits.h"
#include "core/scene/materials/texture.h"

namespace brume {

// Reads a texture by its content: PNG, JPEG, TGA, BMP; of colors also OpenEXR or Radiance HDR,
// which are linear already. Colors of the others are sRGB-encoded, other textures (roughness,
// normals) are linear. Throws InputError: none of these, damaged, more than limits::texture_side
// pixels a side. `warnings`: see read_radiance_map().
std::shared_ptr<const Texture> read_texture(const std::filesystem::path& file, bool has_colors,
                                            std::vector<std::string>* warnings = nullptr);

// The same of a PNG, JPEG, TGA or BMP that is part of another file; `file` is what errors call it.
std::shared_ptr<const Texture> decode_texture(const std::filesystem::path& file,
                                              std::string_view bytes, bool has_colors);

}  // namespace brume
