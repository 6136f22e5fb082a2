#include "core/io/disk/installed_files.h"

#include <dlfcn.h>
#include <link.h>

namespace brume {
namespace fs = std::filesystem;
namespace {

// The program or shared library that holds this code.
fs::path own_file() {
  Dl_info info{};
  link_map* object = nullptr;
  void* entry = nullptr;
  if (::dladdr1(reinterpret_cast<void*>(&own_file), &info, &entry, RTLD_DL_LINKMAP) != 0) {
    object = static_cast<link_map*>(entry);
  }
  std::error_code error;
  // The loader knows of the program itself only what it was called.
  if (object == nullptr || object->l_name[0] == '\0') {
    return fs::read_symlink("/proc/self/exe", error);
  }
  return fs::canonical(object->l_name, error);
}

// `path` relative to the prefix of the installation.
fs::path installed(const fs::path& path) {
  static const fs::path folder = own_file().parent_path();
  // A package of Python keeps all its files in its own folder.
  for (const char* prefix :
       {BRUME_BIN_TO_PREFIX, BRUME_HELPERS_TO_PREFIX, BRUME_LIB_TO_PREFIX, "."}) {
    fs::path candidate = (folder / prefix / path).lexically_normal();
    std::error_code error;
    if (fs::exists(candidate, error)) return candidate;
  }
  return (folder / BRUME_BIN_TO_PREFIX / path).lexically_normal();
}

}  // namespace

fs::path helper_program(std::string_view name) {
  return installed(fs::path(BRUME_HELPERS) / name);
}

fs::path resources_folder() {
  return installed(BRUME_RESOURCES);
}

fs::path manual_folder() {
  return installed(BRUME_MANUAL);
}

}  // namespace brume
