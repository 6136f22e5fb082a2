#pragma once

#include <filesystem>
#include <optional>

namespace brume {

// The file of a frame of a sequence: "smoke_0012.png" of "smoke.png", and of
// "smoke.deep.exr" "smoke_0012.deep.exr".
std::filesystem::path numbered_file(const std::filesystem::path& file, int frame);
// The frame whose file that is; nullopt: it is of none.
std::optional<int> frame_number(const std::filesystem::path& file,
                                const std::filesystem::path& numbered);

}  // namespace brume
