#pragma once

#include <filesystem>
#include <functional>

namespace brume {

// Writes a file so that `file` holds either its old content or the complete new one: `write` gets
// the path of a temporary file beside it, which then takes the place of `file`. If `write` throws
// the temporary file is removed and the exception goes on. Throws InputError if the folder cannot
// be written.
void write_atomically(const std::filesystem::path& file,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

}  // namespace brume
