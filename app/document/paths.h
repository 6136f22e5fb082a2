#pragma once

#include <QString>
#include <filesystem>

namespace brume {

inline std::filesystem::path to_path(const QString& text) {
  return std::filesystem::path(text.toStdU16String());
}

inline QString to_qstring(const std::filesystem::path& path) {
  return QString::fromStdU16String(path.u16string());
}

}  // namespace brume
