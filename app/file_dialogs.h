#pragma once

#include <QString>
#include <filesystem>
#include <optional>
#include <utility>

class QWidget;

namespace brume {

// What file dialogs are about. Each kind opens in the folder that was used last for it, also after
// a restart.
enum class FileKind {
  scene,
  import,
  picture,
  animation,
  medium,
  gather,
  environment,
  material,
  missing
};

// The last folder of a kind, or `fallback` if there is none.
QString last_folder(FileKind kind, const QString& fallback);
void remember_folder(FileKind kind, const std::filesystem::path& file);

// Asks for a file that is there; empty: none was chosen.
std::filesystem::path ask_for_file(QWidget* window, FileKind kind, const QString& title,
                                   const QString& filter, const QString& fallback);

// Asks whether files that are there may be replaced: `file`, or the numbered files of a range of
// frames (numbered_file()). True where there are none.
bool may_replace(QWidget* window, const std::filesystem::path& file,
                 const std::optional<std::pair<int, int>>& frames);

}  // namespace brume
