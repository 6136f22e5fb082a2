#pragma once

#include <filesystem>
#include <memory>

#include "core/scene/materials/measured_brdf.h"

namespace brume {

// A measured BRDF as the MERL database stores it (.binary, little endian): the dimensions 90, 90,
// 180 as int32, then as many doubles for each of red, green and blue, to be multiplied by 1/1500,
// 1.15/1500 and 1.66/1500. Negative values mark what was not measured. Throws InputError: other
// dimensions, another size, a value that is not finite or beyond 1e12.
std::shared_ptr<const MeasuredBrdf> read_merl(const std::filesystem::path& file);

}  // namespace brume
