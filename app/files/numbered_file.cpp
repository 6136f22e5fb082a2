#include "app/files/numbered_file.h"

#include "app/document/paths.h"
#include "render/output/frame_file.h"

namespace brume {

std::filesystem::path numbered_file(const std::filesystem::path& file, int frame) {
  std::filesystem::path stem = file.stem();
  QString extension = to_qstring(file.extension());
  if (is_deep_file(file)) {
    extension = to_qstring(stem.extension()) + extension;
    stem = stem.stem();
  }
  const QString name =
      QString("%1_%2%3").arg(to_qstring(stem)).arg(frame, 4, 10, QChar('0')).arg(extension);
  return file.parent_path() / to_path(name);
}

}  // namespace brume
