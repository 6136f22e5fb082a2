#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <string_view>
#include <vector>

#include "core/io/disk/temporary_files.h"

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

// Files that belong together, as a stage and its volumes: while one lives, what this thread writes
// by write_atomically() waits under another name, and commit() replaces all files, in the order
// they were written in. Without that none is replaced. One at a time per thread.
class FileGroup {
 public:
  FileGroup();
  ~FileGroup();
  FileGroup(const FileGroup&) = delete;
  FileGroup& operator=(const FileGroup&) = delete;

  // Throws InputError.
  void commit();

  // For write_atomically(): writes what is to replace `target`, which errors call `file`.
  void write(const std::filesystem::path& file, const std::filesystem::path& target,
             const std::function<void(const std::filesystem::path& temporary)>& write);

 private:
  struct Member {
    std::filesystem::path file;
    std::filesystem::path written;
    std::filesystem::path target;
  };

  std::vector<Member> members_;
  std::map<std::filesystem::path, StagingFolder> stages_;  // by the folder of the targets
};

// Removes the temporary files in a folder that programs left which were killed: those that no
// program holds locked, on this machine or, where the file system tells, on another.
void remove_abandoned_files(const std::filesystem::path& folder);

// Flushes a folder's entries to disk, so that files written as above survive a crash. Throws
// InputError.
void flush_folder(const std::filesystem::path& folder);

}  // namespace brume
