#pragma once

#include <filesystem>
#include <ostream>
#include <string_view>

#include "core/io/import/raw_scene.h"

namespace brume {

// A raw scene as bytes, as the program that reads scenes hands it to the one that asked. Files are
// not part of it.
void write_raw_scene(std::ostream& out, const RawScene& scene);

// The bytes may be anything: throws InputError for what write_raw_scene() does not write, such as
// indices out of range. `file`: the scene's, for errors.
RawScene read_raw_scene(const std::filesystem::path& file, std::string_view bytes);

}  // namespace brume
