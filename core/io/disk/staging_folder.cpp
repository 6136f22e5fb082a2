#include "core/io/disk/staging_folder.h"

#include <unistd.h>

#include <atomic>
#include <string>

#include "brume/error.h"

namespace brume {
namespace fs = std::filesystem;

StagingFolder::StagingFolder(const fs::path& parent, const fs::path& user) {
  static std::atomic<unsigned> counter = 0;
  std::error_code error;
  do {
    path_ = fs::weakly_canonical(parent, error) /
            (".brume-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp");
  } while (!error && fs::exists(path_));
  name_ = TemporaryName(path_);
  if (!error) fs::create_directory(path_, error);
  if (error) throw InputError(user, "", "cannot be created: " + error.message());
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace brume
