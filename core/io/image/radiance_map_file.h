#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "brume/limits.h"
#include "core/scene/lights/radiance_map.h"

namespace brume {

// Reads an environment map, latitude and longitude: the picture of an OpenEXR file (see
// read_exr_picture), converted to linear Rec. 709, or Radiance HDR. Negative values become 0, and
// with a warning NaN; infinity becomes, with a warning, the largest value of the picture, at least
// that of half floats. Throws InputError naming the pixel of a value beyond limits::intensity, or a
// cube map, and the errors of read_exr_picture and read_hdr.
std::shared_ptr<const RadianceMap> read_radiance_map(const std::filesystem::path& file,
                                                     std::vector<std::string>* warnings = nullptr);

}  // namespace brume
