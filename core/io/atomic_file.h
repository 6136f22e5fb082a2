#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>

namespace brume {

// Where the bytes of a file go: the end of a chain of symbolic links, which need not exist yet.
// Throws InputError where the chain has no end.
std::filesystem::path link_target(const std::filesystem::path& file);

// Throws InputError if `file` cannot be written: its folder is missing or not writable, or it is
// a folder or a device itself. Asked before long work whose result would be lost.
void check_writable(const std::filesystem::path& file);

// Writes a file so that `file` holds either its old content or the complete new one: `write` gets
// the path of a temporary file beside it, which then takes the place of `file`. An existing file
// keeps its permissions, a symbolic link stays and its target is written. If `write` throws the
// temporary file is removed and the exception goes on. Throws InputError if the folder cannot be
// written.
void write_atomically(const std::filesystem::path& file,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

// The same through a stream, for all that can write to one: every write, the flush and the close
// are checked. The stream throws std::ios_base::failure; it may get lost in `write`, the error does
// not.
void write_atomically(const std::filesystem::path& file,
                      const std::function<void(std::ostream& out)>& write);

// The same for content that is at hand.
void write_atomically(const std::filesystem::path& file, std::string_view content);

// Waits until the names in a folder are on the disk, as their files are when they were written as
// above: a crash later on leaves them. Throws InputError where the disk says no.
void flush_folder(const std::filesystem::path& folder);

}  // namespace brume
