#pragma once

#include <filesystem>

#include "brume/limits.h"
#include "core/scene/lights/radiance_map.h"

namespace brume {

// A Radiance picture (.hdr): 32-bit RGBE, flat or with either run-length code, its rows in any
// order of the format ("-Y height +X width" and its turns); EXPOSURE and COLORCORR in the header
// are undone. What stands behind the last row is left out. All values are finite and >= 0. Throws
// InputError naming the line of the header or the row: no such picture, XYZE, truncated, runs
// beyond a row, larger than limits::image_side a side.
RadianceMap read_hdr(const std::filesystem::path& file);

}  // namespace brume
