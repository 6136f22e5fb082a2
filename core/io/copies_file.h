#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "brume/copies.h"

namespace brume {

// Placements of copies: PLY or CSV with x, y, z, qw, qx, qy, qz and scale; the rotation and the
// scale may be missing. Throws InputError that names vertex or line.
CopyPlacements read_copies(const std::filesystem::path& file, std::size_t max_count,
                           std::vector<std::string>* warnings = nullptr);

}  // namespace brume
