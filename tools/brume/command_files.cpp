#include "tools/brume/command_files.h"

#include <sys/stat.h>

#include "brume/error.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/scene/missing_files.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"
#include "tools/brume/command.h"
#include "tools/brume/progress_line.h"

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

namespace {

SceneDocument load(const std::string& file, std::vector<std::string>& warnings,
                   std::vector<std::filesystem::path>* missing) {
  const ProgressLine line("reading " + file);
  if (missing == nullptr) return load_document(file, &warnings);
  MissingFiles files;
  files.only_frames = true;
  SceneDocument document = load_document(file, &warnings, files);
  *missing = std::move(files.missing);
  return document;
}

}  // namespace

SceneDocument read_document(const std::string& file, CommandFiles& files,
                            std::vector<std::filesystem::path>* missing) {
  files.add_input(file);
  std::vector<std::string> warnings;
  SceneDocument document = load(file, warnings, missing);
  print_warnings(warnings);
  for (const std::filesystem::path& other : files_of(document)) files.add_input(other);
  return document;
}

Scene read_scene(const std::string& file, CommandFiles& files) {
  return read_document(file, files).scene;
}

}  // namespace brume
