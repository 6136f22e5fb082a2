#pragma once

#include <filesystem>
#include <string_view>

namespace brume {

// Files that are nobody else's to read: what a user works on, and pictures of it. Folders get 0700
// and files 0600, also those that are there with other permissions.

// Makes a folder, and those it is in. Where that fails, writing into it will say why.
std::filesystem::path make_private_folder(const std::filesystem::path& folder);

// As write_atomically(); the file is never readable by others, not even while it is written.
void write_private(const std::filesystem::path& file, std::string_view content);

// Of a file that somebody else has written.
void make_private(const std::filesystem::path& file);

}  // namespace brume
