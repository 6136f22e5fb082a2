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

}  // namespace brume
