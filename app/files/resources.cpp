#include "app/files/resources.h"

#include <QCoreApplication>

#include "app/document/paths.h"

namespace brume {

std::filesystem::path resources_folder() {
  const auto installed = to_path(QCoreApplication::applicationDirPath() + "/../share/brume");
  std::error_code error;
  if (std::filesystem::is_directory(installed, error)) return installed;
  return BRUME_RESOURCES;
}

}  // namespace brume
