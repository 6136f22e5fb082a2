#include "core/io/disk/file_bytes.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>

#include "brume/error.h"

namespace brume {
namespace fs = std::filesystem;

std::uintmax_t regular_file_size(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) throw InputError(file, "", "no such file");
  if (error) throw InputError(file, "", error.message());
  if (fs::is_directory(status)) throw InputError(file, "", "is a folder, not a file");
  // A pipe or a device could block or never end.
  if (!fs::is_regular_file(status)) throw InputError(file, "", "is not a regular file");
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) throw InputError(file, "", error.message());
  return size;
}

std::string read_first_bytes(const fs::path& file, std::size_t count) {
  // A repository has this in place of a file that was not fetched.
  constexpr std::string_view lfs_pointer = "version https://git-lfs.github.com/spec/";
  const std::size_t read_count = static_cast<std::size_t>(
      std::min<std::uintmax_t>(std::max(count, lfs_pointer.size()), regular_file_size(file)));
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file, "", std::string("cannot be opened: ") + std::strerror(errno));
  std::string bytes(read_count, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(read_count));
  if (in.bad()) throw InputError(file, "", "cannot be read");
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (bytes.starts_with(lfs_pointer)) {
    throw InputError(file, "",
                     "is a pointer of Git LFS, not the file itself; git lfs pull gets it");
  }
  bytes.resize(std::min(bytes.size(), count));
  return bytes;
}

std::string read_bytes(const fs::path& file) {
  const std::uintmax_t size = regular_file_size(file);
  if (size > limits::file_bytes) {
    throw InputError(file, "",
                     "found " + std::to_string(size) + " bytes; allowed: at most " +
                         std::to_string(limits::file_bytes));
  }
  return read_first_bytes(file, static_cast<std::size_t>(size));
}

std::string lower_case_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace brume
