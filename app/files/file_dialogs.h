#pragma once

#include <QString>
#include <filesystem>
#include <optional>
#include <utility>

class QWidget;

namespace brume {

// Kinds of file dialogs. Each opens in the folder last used for its kind, across sessions.
enum class FileKind {
  scene,
  import,
  picture,
  medium,
  gather,
  environment,
  material,
  color,
  profile,
  texture,
  plate,
  missing,
  asset
};

// The last folder of a kind, or `fallback`.
QString last_folder(FileKind kind, const QString& fallback);
void remember_folder(FileKind kind, const std::filesystem::path& file);

// Asks for an existing file; empty if cancelled.
std::filesystem::path ask_for_file(QWidget* window, FileKind kind, const QString& title,
                                   const QString& filter, const QString& fallback);

// Asks before overwriting `file`, or the numbered files of a range of frames (numbered_file()).
// True if there are none.
bool may_replace(QWidget* window, const std::filesystem::path& file,
                 const std::optional<std::pair<int, int>>& frames);

}  // namespace brume
