#pragma once

#include <assimp/IOSystem.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "brume/limits.h"

namespace brume {

// Where a file is that a scene in `folder` names: there, or, if nothing is there, beside the scene,
// since many files name folders of the machine they were made on. See find_file_named_alike().
std::filesystem::path place_of(const std::filesystem::path& named,
                               const std::filesystem::path& folder);

// The files that assimp may read for a scene: regular ones of at most limits::file_bytes. None is
// written.
class LimitedFiles : public Assimp::IOSystem {
 public:
  explicit LimitedFiles(const std::filesystem::path& scene) : scene_(scene.lexically_normal()) {}

  bool Exists(const char* file) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

  // From here on this text is read in place of the scene's own file.
  void replace_scene(std::string text) { scene_text_ = std::move(text); }

  // Those that were opened.
  [[nodiscard]] const std::vector<std::filesystem::path>& opened() const { return opened_; }
  // Those that could not be, in the order of the attempts.
  [[nodiscard]] const std::vector<std::filesystem::path>& missed() const { return missed_; }

 private:
  // The file that assimp asks for, in the folders where it is. It takes what an OBJ's line mtllib
  // says for one name: where there is no such file, it is several with blanks between them.
  [[nodiscard]] std::vector<std::filesystem::path> places_of(const std::string& name) const;

  std::filesystem::path scene_;
  std::optional<std::string> scene_text_;
  std::vector<std::filesystem::path> opened_;
  std::vector<std::filesystem::path> missed_;
};

}  // namespace brume
