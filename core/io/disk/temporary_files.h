#pragma once

#include <filesystem>

namespace brume {

// Registers a file or folder for removal when a signal ends the program. Register before creating
// it, so no signal can leave it behind.
class TemporaryName {
 public:
  TemporaryName() = default;
  explicit TemporaryName(const std::filesystem::path& path);
  ~TemporaryName();  // unregisters; the file stays
  TemporaryName(TemporaryName&& other) noexcept;
  TemporaryName& operator=(TemporaryName&& other) noexcept;

 private:
  int slot_ = -1;
};

// Handles SIGINT, SIGTERM and SIGHUP unless ignored: removes registered files, then lets the signal
// end the program. Ignores SIGXFSZ, so that writing beyond the limit fails like a full disk.
void remove_temporary_files_on_signals();

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
