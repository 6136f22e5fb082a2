#include "app/files/numbered_file.h"

#include "app/document/paths.h"
#include "render/output/frame_file.h"

namespace brume {
namespace {

struct NameParts {
  QString stem, extension;
};

NameParts parts_of(const std::filesystem::path& file) {
  const std::filesystem::path stem = file.stem();
  const QString extension = to_qstring(file.extension());
  if (!is_deep_file(file)) return {to_qstring(stem), extension};
  return {to_qstring(stem.stem()), to_qstring(stem.extension()) + extension};
}

}  // namespace

std::filesystem::path numbered_file(const std::filesystem::path& file, int frame) {
  const auto [stem, extension] = parts_of(file);
  const QString name = QString("%1_%2%3").arg(stem).arg(frame, 4, 10, QChar('0')).arg(extension);
  return file.parent_path() / to_path(name);
}

std::optional<int> frame_number(const std::filesystem::path& file,
                                const std::filesystem::path& numbered) {
  const auto [stem, extension] = parts_of(file);
  const QString name = to_qstring(numbered.filename());
  const qsizetype digits = name.size() - stem.size() - 1 - extension.size();
  if (digits <= 0) return std::nullopt;
  const int frame = name.mid(stem.size() + 1, digits).toInt();
  return numbered_file(file, frame) == numbered ? std::optional(frame) : std::nullopt;
}

}  // namespace brume
