#pragma once

#include <filesystem>
#include <stop_token>

#include "core/io/import/raw_scene.h"

namespace brume {

// Reads a scene of a format that a library reads (.obj, .fbx) by the program brume-scene-reader,
// which is installed with the running one: what a hostile file does to the library ends with that
// program, within limits of memory and time. Throws InputError, also where the program crashes,
// runs into a limit or is missing. An empty scene when stopped.
RawScene read_by_program(const std::filesystem::path& file, const std::stop_token& stop);

}  // namespace brume
