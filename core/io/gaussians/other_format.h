#pragma once

#include <filesystem>
#include <string_view>

namespace brume {

// Refuses a file of a format in which no Gaussians are read but that is often taken for one:
// compressed splats, archives, volumes. `begin` has its first bytes. Throws InputError saying what
// it is, and which program makes Gaussians of it.
void refuse_other_format(const std::filesystem::path& file, std::string_view begin);

// Says so of compressed splats; `what` names their format.
[[noreturn]] void refuse_compressed_splats(const std::filesystem::path& file,
                                           std::string_view what);

}  // namespace brume
