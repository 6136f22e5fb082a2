#pragma once

#include <filesystem>
#include <string>

#include "brume/limits.h"

namespace brume {

// The size in bytes of a regular file. Throws InputError: missing, a folder or a device.
std::uintmax_t regular_file_size(const std::filesystem::path& file);

// All bytes of a regular file. Throws InputError also if it is larger than limits::file_bytes,
// cannot be read, or is what Git LFS leaves in place of a file.
std::string read_bytes(const std::filesystem::path& file);

// At most `count` bytes from the start of a regular file. Throws InputError, as read_bytes() does.
std::string read_first_bytes(const std::filesystem::path& file, std::size_t count);

// ".png" of "a/B.PNG".
std::string lower_case_extension(const std::filesystem::path& file);

}  // namespace brume
