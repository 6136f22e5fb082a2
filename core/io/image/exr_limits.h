#pragma once

#include <ImfHeader.h>

#include <filesystem>

namespace brume {

// Checks the sizes that an OpenEXR file declares against its length, since OpenEXR allocates memory
// for them first. All throw InputError.

// No attribute of any header is longer than the file. Call before OpenEXR opens it.
void check_exr_attributes(const std::filesystem::path& file);

// Size, channels and blocks of a flat image are within limits, and no more than a file of this
// length and compression can hold.
void check_exr_image(const std::filesystem::path& file, const Imf::Header& header);

// No channel is subsampled.
void check_exr_sampling(const std::filesystem::path& file, const Imf::Header& header);

}  // namespace brume
