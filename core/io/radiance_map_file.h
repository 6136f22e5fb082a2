#pragma once

#include <filesystem>
#include <memory>

#include "core/scene/radiance_map.h"

namespace brume {

// An image that can light a scene: OpenEXR with the channels R G B, or Radiance HDR. Values below
// 0, which resampling leaves behind, become 0. Throws InputError naming the pixel of a value that
// is not finite or beyond limits::intensity, and what read_exr and read_hdr throw.
std::shared_ptr<const RadianceMap> read_radiance_map(const std::filesystem::path& file);

}  // namespace brume
