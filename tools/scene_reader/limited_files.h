#pragma once

#include <assimp/IOSystem.hpp>
#include <filesystem>
#include <vector>

#include "brume/limits.h"

namespace brume {

// The files that assimp may read: regular ones of at most limits::file_bytes. None is written.
class LimitedFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char* file) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

  // Those that were opened.
  [[nodiscard]] const std::vector<std::filesystem::path>& opened() const { return opened_; }

 private:
  std::vector<std::filesystem::path> opened_;
};

}  // namespace brume
