#include "app/document/private_files.h"

#include <fstream>

#include "brume/error.h"
#include "core/io/disk/atomic_file.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr fs::perms private_file = fs::perms::owner_read | fs::perms::owner_write;

}  // namespace

fs::path make_private_folder(const fs::path& folder) {
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  fs::permissions(folder, fs::perms::owner_all, ignored);
  return folder;
}

void write_private(const fs::path& file, std::string_view content) {
  make_private(file);  // the new one gets the permissions of the old
  write_atomically(file, [&](const fs::path& temporary) {
    fs::permissions(temporary, private_file);
    std::ofstream out(temporary, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) throw InputError(file, "", "cannot be written: the disk may be full");
  });
}

void make_private(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) fs::permissions(file, private_file, ignored);
}

}  // namespace brume
