#pragma once

#include <filesystem>

namespace brume {

// The folder of templates, sample scenes and their pictures: share/brume beside the program's
// folder, or else that of the source tree the program was built from. It may not exist.
std::filesystem::path resources_folder();

}  // namespace brume
