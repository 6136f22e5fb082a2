#include "tools/brume/command_files.h"

#include <sys/stat.h>

#include "brume/error.h"
#include "core/io/disk/atomic_file.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const fs::path& output, const std::string& other) {
  throw InputError(output, "", "is the same file as the " + other + "; allowed: another file");
}

}  // namespace

void CommandFiles::add_input(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return;
  const auto [known, is_new] =
      existing_.try_emplace({status.st_dev, status.st_ino}, Known{file, false});
  if (known->second.is_output) refuse(known->second.file, "input " + file.string());
}

CommandFiles::~CommandFiles() {
  std::error_code ignored;
  while (!made_.empty()) {
    fs::remove(made_.back(), ignored);
    made_.pop_back();
  }
}

void CommandFiles::make_folder(const fs::path& folder) {
  if (folder.empty()) return;
  std::error_code error;
  std::vector<fs::path> missing;
  for (fs::path it = fs::absolute(folder); !fs::exists(it, error); it = it.parent_path()) {
    missing.push_back(it);
  }
  for (; !missing.empty(); missing.pop_back()) {
    const fs::path& next = missing.back();
    if (fs::create_directory(next, error)) made_.push_back(next);
    if (error) throw InputError(next, "", "cannot be created: " + error.message());
  }
}

void CommandFiles::add_output(const fs::path& file) {
  make_folder(link_target(file).parent_path());
  check_writable(file);
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0) {
    const auto [known, is_new] =
        existing_.try_emplace({status.st_dev, status.st_ino}, Known{file, true});
    if (is_new) return;
    refuse(file, (known->second.is_output ? "output " : "input ") + known->second.file.string());
  }
  // Not there yet: names are all there is to compare.
  const fs::path target = link_target(file);
  std::error_code error;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!outputs_.insert(fs::weakly_canonical(folder, error) / target.filename()).second) {
    refuse(file, "output " + target.string());
  }
}

}  // namespace brume
