#pragma once

#include <cstddef>
#include <span>

#include "core/io/scene/usd_file.h"
#include "core/io/scene/usd_material.h"
#include "core/io/scene/usd_text.h"

namespace brume {

// Writes surface i of frames: a mesh with its place, points and normals in each frame, its
// material, and its copies as a PointInstancer.
void write_usd_surface(UsdText& out, std::span<const UsdFrame> frames, std::size_t i,
                       UsdTextures& textures);

}  // namespace brume
