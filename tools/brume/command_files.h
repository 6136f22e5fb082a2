#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace brume {

// The files of a command, registered before work begins. No output may be an input, nor two outputs
// the same file, resolving symbolic and hard links and spellings like ./a.
class CommandFiles {
 public:
  // An input. One that is not there is left to its reader. Throws InputError if it is an output.
  void add_input(const std::filesystem::path& file);
  // An output. Throws InputError if it cannot be written, is an input, or is another output.
  void add_output(const std::filesystem::path& file);

 private:
  using Identity = std::pair<dev_t, ino_t>;
  struct Known {
    std::filesystem::path file;
    bool is_output;
  };

  std::map<Identity, Known> existing_;
  std::set<std::filesystem::path> outputs_;  // where their bytes go
};

}  // namespace brume
