#include "app/files/numbered_file.h"

#include "app/document/paths.h"

namespace brume {

std::filesystem::path numbered_file(const std::filesystem::path& file, int frame) {
  const QString name = QString("%1_%2%3")
                           .arg(to_qstring(file.stem()))
                           .arg(frame, 4, 10, QChar('0'))
                           .arg(to_qstring(file.extension()));
  return file.parent_path() / to_path(name);
}

}  // namespace brume
