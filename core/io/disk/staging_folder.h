#pragma once

#include <filesystem>

#include "core/io/disk/temporary_files.h"

namespace brume {

// A new folder in which files wait until all of them are complete. It goes with what is still in
// it, also when a signal ends the program.
class StagingFolder {
 public:
  // In `parent`; `user`: what it is for, for errors. Throws InputError.
  StagingFolder(const std::filesystem::path& parent, const std::filesystem::path& user);
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  TemporaryName name_;
};

}  // namespace brume
