#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/io/scene/scene_document.h"

namespace brume {

// The files of a command, registered before work begins. No output may be an input, nor two outputs
// the same file, resolving symbolic and hard links and spellings like ./a.
class CommandFiles {
 public:
  CommandFiles() = default;
  CommandFiles(CommandFiles&&) = default;
  CommandFiles& operator=(CommandFiles&&) = default;
  // Removes the folders it made that are still empty: nothing was written.
  ~CommandFiles();

  // An input. One that is not there is left to its reader. Throws InputError if it is an output.
  void add_input(const std::filesystem::path& file);
  // An output, whose folder is made. Throws InputError if it cannot be written, is an input, or is
  // another output.
  void add_output(const std::filesystem::path& file);
  // Makes a folder and those it is in. Throws InputError.
  void make_folder(const std::filesystem::path& folder);

 private:
  using Identity = std::pair<dev_t, ino_t>;
  struct Known {
    std::filesystem::path file;
    bool is_output;
  };

  std::map<Identity, Known> existing_;
  std::set<std::filesystem::path> outputs_;  // where their bytes go
  std::vector<std::filesystem::path> made_;  // folders, the outer first
};

// Loads the scene of a command, whose other files become inputs of it; prints what there is to warn
// of. Files of some frames of sequences may be missing if `missing` is given, which gets them.
// Throws InputError.
SceneDocument read_document(const std::string& file, CommandFiles& files,
                            std::vector<std::filesystem::path>* missing = nullptr);
// The scene of it alone.
Scene read_scene(const std::string& file, CommandFiles& files);

}  // namespace brume
