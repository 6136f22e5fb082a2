#pragma once

#include <filesystem>

namespace brume {

// The name of a file or folder that goes where a signal ends the program. Named before it is made,
// so that no moment is left in which a signal would leave it behind.
class TemporaryName {
 public:
  TemporaryName() = default;
  explicit TemporaryName(const std::filesystem::path& path);
  ~TemporaryName();  // forgets the name; what bears it stays
  TemporaryName(TemporaryName&& other) noexcept;
  TemporaryName& operator=(TemporaryName&& other) noexcept;

 private:
  int slot_ = -1;
};

// Of SIGINT, SIGTERM and SIGHUP, where they are not ignored: removes what has a TemporaryName, then
// lets the signal end the program as it does by itself. SIGXFSZ is ignored: writing beyond the
// limit then fails as it does on a full disk.
void remove_temporary_files_on_signals();

}  // namespace brume
