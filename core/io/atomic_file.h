#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>

namespace brume {

// Resolves a chain of symbolic links; the target need not exist. Throws InputError for a cycle.
std::filesystem::path link_target(const std::filesystem::path& file);

// Throws InputError if `file` cannot be written: its folder is missing or read-only, or it is a
// folder or device. Call before long work.
void check_writable(const std::filesystem::path& file);

// Replaces a file atomically: `write` writes a temporary file next to it, which is then renamed.
// Preserves permissions and symbolic links (the target is replaced). If `write` throws, the
// temporary file is removed and the exception propagates. Throws InputError if the folder is not
// writable.
void write_atomically(const std::filesystem::path& file,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

// The same through a stream: every write, flush and close is checked. The stream throws
// std::ios_base::failure; should `write` swallow it, the error is still reported.
void write_atomically(const std::filesystem::path& file,
                      const std::function<void(std::ostream& out)>& write);

// The same for given content.
void write_atomically(const std::filesystem::path& file, std::string_view content);

// Removes the temporary files in a folder that programs left which were killed: those that no
// program holds locked, on this machine or, where the file system tells, on another.
void remove_abandoned_files(const std::filesystem::path& folder);

// Flushes a folder's entries to disk, so that files written as above survive a crash. Throws
// InputError.
void flush_folder(const std::filesystem::path& folder);

}  // namespace brume
