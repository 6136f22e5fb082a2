#pragma once

#include <filesystem>
#include <memory>

#include "brume/limits.h"
#include "core/scene/lights/photometric_profile.h"

namespace brume {

// A photometric data file of IES LM-63, of 1986 to 2019, type C photometry. Only the relative
// intensities are used: neither the dimensions of the luminous opening nor the factors for tilt,
// ballast and lumens, which scale all of them. Azimuths from 0 to 90 or 180 degrees are mirrored,
// as are those from 90 to 270. Throws InputError: what is no such file, another photometry, angles
// that do not ascend, negative intensities, nothing but zeros, more than limits::profile_angles
// angles.
std::shared_ptr<const PhotometricProfile> read_ies(const std::filesystem::path& file);

}  // namespace brume
