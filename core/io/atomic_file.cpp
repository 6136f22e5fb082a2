#include "core/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "brume/error.h"
#include "core/io/temporary_files.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

std::string reason() {
  return std::strerror(errno);
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// A new empty file next to `target`, with the permissions a new file gets from the umask.
fs::path create_temporary(const fs::path& file, const fs::path& target, TemporaryName& name) {
  static std::atomic<unsigned> counter = 0;
  for (;;) {
    fs::path temporary = folder_of(target) / (".brume-" + std::to_string(::getpid()) + "-" +
                                              std::to_string(counter++) + ".tmp");
    name = TemporaryName(temporary);
    const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0) {
      ::close(fd);
      return temporary;
    }
    if (errno != EEXIST) throw InputError(file, "", "cannot be written: " + reason());
  }
}

// A crash after the rename must not leave a name without content.
void flush_to_disk(const fs::path& path, int flags) {
  const int fd = ::open(path.c_str(), flags | O_CLOEXEC);
  if (fd < 0) return;
  const bool failed = ::fsync(fd) != 0 && errno != EINVAL && errno != EROFS;
  const std::string why = failed ? reason() : "";
  ::close(fd);
  if (failed) throw InputError(path, "", "cannot be written: " + why);
}

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

void write_atomically(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  check_writable(file);
  const fs::path target = link_target(file);
  TemporaryName name;
  const fs::path temporary = create_temporary(file, target, name);
  try {
    write(temporary);
    struct stat old {};
    if (::stat(target.c_str(), &old) == 0) ::chmod(temporary.c_str(), old.st_mode & 07777);
    flush_to_disk(temporary, O_RDONLY);
    if (::rename(temporary.c_str(), target.c_str()) != 0) {
      throw InputError(file, "", "cannot be written: " + reason());
    }
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
