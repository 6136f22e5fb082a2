#include "core/io/disk/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "brume/error.h"
#include "core/io/disk/temporary_files.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

std::string reason() {
  return std::strerror(errno);
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// A new empty file next to `target`, with the permissions a new file gets from the umask. It is
// locked as long as this lives, by which remove_abandoned_files() knows that it is being written.
class TemporaryFile {
 public:
  TemporaryFile(const fs::path& file, const fs::path& target) {
    static std::atomic<unsigned> counter = 0;
    for (;;) {
      path_ = folder_of(target) /
              (prefix + std::to_string(::getpid()) + "-" + std::to_string(counter++) + suffix);
      name_ = TemporaryName(path_);
      fd_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (fd_ < 0 && errno != EEXIST) throw InputError(file, "", "cannot be written: " + reason());
      if (fd_ < 0) continue;
      // Where there are no locks, nothing is taken for abandoned.
      struct stat made {};
      if (::flock(fd_, LOCK_EX) != 0 || ::fstat(fd_, &made) != 0 || made.st_nlink > 0) return;
      ::close(fd_);  // removed before it was locked
    }
  }
  ~TemporaryFile() { ::close(fd_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

  static constexpr const char* prefix = ".brume-";
  static constexpr const char* suffix = ".tmp";

 private:
  fs::path path_;
  TemporaryName name_;
  int fd_ = -1;
};

// A crash after the rename must not leave a name without content.
void flush_to_disk(const fs::path& path, int flags) {
  const int fd = ::open(path.c_str(), flags | O_CLOEXEC);
  if (fd < 0) return;
  const bool failed = ::fsync(fd) != 0 && errno != EINVAL && errno != EROFS;
  const std::string why = failed ? reason() : "";
  ::close(fd);
  if (failed) throw InputError(path, "", "cannot be written: " + why);
}

// Before a complete file takes the place of another, whose permissions it gets.
void make_ready(const fs::path& written, const fs::path& target) {
  struct stat old {};
  if (::stat(target.c_str(), &old) == 0) ::chmod(written.c_str(), old.st_mode & 07777);
  flush_to_disk(written, O_RDONLY);
}

void replace(const fs::path& file, const fs::path& written, const fs::path& target) {
  if (::rename(written.c_str(), target.c_str()) != 0) {
    throw InputError(file, "", "cannot be written: " + reason());
  }
}

thread_local FileGroup* group_of_thread = nullptr;

}  // namespace

fs::path link_target(const fs::path& file) {
  std::error_code error;
  if (!fs::is_symlink(file, error)) return file;
  fs::path target = fs::weakly_canonical(file, error);
  if (error) throw InputError(file, "", "cannot be written: " + error.message());
  if (!fs::is_symlink(target, error)) return target;
  return link_target(folder_of(file) / fs::read_symlink(file, error));  // to what is not there
}

void flush_folder(const fs::path& folder) {
  flush_to_disk(folder, O_RDONLY | O_DIRECTORY);
}

void check_writable(const fs::path& file) {
  const fs::path target = link_target(file);
  const fs::path folder = folder_of(target);
  std::error_code error;
  if (!target.has_filename()) throw InputError(file, "", "cannot be written: not a file name");
  if (!fs::is_directory(folder, error)) {
    throw InputError(file, "", "cannot be written: there is no folder " + folder.string());
  }
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) throw InputError(file, "", "cannot be written: it is a folder");
  if (fs::exists(status)) {
    if (!fs::is_regular_file(status)) {
      throw InputError(file, "", "cannot be written: it is not a regular file");
    }
    if (::access(target.c_str(), W_OK) != 0) {
      throw InputError(file, "", "cannot be written: " + reason());
    }
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    throw InputError(file, "", "cannot be written: its folder is not writable: " + reason());
  }
}

FileGroup::FileGroup() {
  assert(group_of_thread == nullptr);
  group_of_thread = this;
}

FileGroup::~FileGroup() {
  group_of_thread = nullptr;
}

void FileGroup::write(const fs::path& file, const fs::path& target,
                      const std::function<void(const fs::path&)>& write) {
  const fs::path folder = folder_of(target);
  const StagingFolder& stage = stages_.try_emplace(folder, folder, file).first->second;
  const fs::path written = stage.path() / std::to_string(members_.size());
  write(written);
  make_ready(written, target);
  members_.push_back({file, written, target});
}

void FileGroup::commit() {
  for (const auto& [file, written, target] : members_) replace(file, written, target);
  for (const auto& [folder, stage] : stages_) flush_folder(folder);
  members_.clear();
}

void remove_abandoned_files(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(TemporaryFile::prefix) || !name.ends_with(TemporaryFile::suffix))
      continue;
    // A pipe of that name would wait for its reader.
    const int fd = ::open(entry->path().c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (fd < 0) continue;
    struct stat found {};
    const bool is_file = ::fstat(fd, &found) == 0 && S_ISREG(found.st_mode);
    if (is_file && ::flock(fd, LOCK_EX | LOCK_NB) == 0) ::unlink(entry->path().c_str());
    ::close(fd);
  }
}

void write_atomically(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  check_writable(file);
  const fs::path target = link_target(file);
  if (group_of_thread != nullptr) {
    group_of_thread->write(file, target, write);
    return;
  }
  const TemporaryFile made(file, target);
  const fs::path& temporary = made.path();
  try {
    write(temporary);
    make_ready(temporary, target);
    replace(file, temporary, target);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  flush_folder(folder_of(target));
}

void write_atomically(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  write_atomically(file, [&](const fs::path& temporary) {
    errno = 0;
    std::ofstream out;
    out.exceptions(std::ios::badbit | std::ios::failbit);
    try {
      out.open(temporary, std::ios::binary);
      write(out);
      out.close();
    } catch (...) {
      if (out) throw;
    }
    // Asked of the stream: libraries keep the exception of a failed write to themselves.
    if (!out) {
      throw InputError(file, "",
                       "cannot be written: " + (errno == 0 ? "the disk may be full" : reason()));
    }
  });
}

void write_atomically(const fs::path& file, std::string_view content) {
  write_atomically(file, [&](std::ostream& out) {
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
  });
}

}  // namespace brume
