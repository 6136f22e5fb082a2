#pragma once

#include <filesystem>

namespace brume {

// Where a file is that another file names: there, or, if nothing is there, where every part of the
// name is one that is alike but for its case, for how letters with accents are stored (composed, or
// as macOS writes them), for blanks at its end, and for backslashes between folders. The name
// itself where there is no such file.
std::filesystem::path find_file_named_alike(const std::filesystem::path& file);

}  // namespace brume
