#pragma once

#include <filesystem>

namespace brume {

// The file of a frame of a sequence: "smoke_0012.png" of "smoke.png", and of
// "smoke.deep.exr" "smoke_0012.deep.exr".
std::filesystem::path numbered_file(const std::filesystem::path& file, int frame);

}  // namespace brume
