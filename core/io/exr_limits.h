#pragma once

#include <ImfHeader.h>

#include <filesystem>

namespace brume {

// What an OpenEXR file claims, held against what it can hold: OpenEXR takes memory for it before it
// reads on. Both throw InputError.

// No attribute of any header is longer than the file. To be asked before OpenEXR opens it.
void check_exr_attributes(const std::filesystem::path& file);

// The size, the channels and the blocks of a flat image: within limits, and no more than a file of
// this length and compression can hold.
void check_exr_image(const std::filesystem::path& file, const Imf::Header& header);

}  // namespace brume
