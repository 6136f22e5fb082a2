#pragma once

#include <filesystem>
#include <memory>

#include "brume/limits.h"
#include "core/scene/radiance_map.h"

namespace brume {

// Reads an environment map: OpenEXR with channels R G B, or Radiance HDR. Negative values (from
// resampling) become 0. Throws InputError naming the pixel of a value that is not finite or beyond
// limits::intensity, and the errors of read_exr and read_hdr.
std::shared_ptr<const RadianceMap> read_radiance_map(const std::filesystem::path& file);

}  // namespace brume
