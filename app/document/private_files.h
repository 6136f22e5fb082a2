#pragma once

#include <filesystem>
#include <string_view>

namespace brume {

// Files private to the user: backups and scene pictures. Folders get mode 0700, files 0600, also
// existing ones.

// Creates a folder and its parents. On failure, writing into it will report the error.
std::filesystem::path make_private_folder(const std::filesystem::path& folder);

// write_atomically() with mode 0600 from the start.
void write_private(const std::filesystem::path& file, std::string_view content);

// Restricts an existing file to mode 0600.
void make_private(const std::filesystem::path& file);

}  // namespace brume
