#include "app/files/file_dialogs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QSettings>
#include <algorithm>

#include "app/document/paths.h"
#include "app/files/numbered_file.h"
#include "app/widgets/question.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

QString dialog_text(const char* text, int count = -1) {
  return QCoreApplication::translate("FileDialogs", text, nullptr, count);
}

QString settings_key(FileKind kind) {
  constexpr const char* names[]{"scene",       "import",   "picture", "medium",  "gather",
                                "environment", "material", "color",   "profile", "texture",
                                "plate",       "missing",  "asset"};
  return QString("folders/") + names[static_cast<int>(kind)];
}

// The files of these frames that are there, in order. Lists the folder: a range may be long.
std::vector<QString> present_frames(const fs::path& file, const std::pair<int, int>& frames) {
  const QString stem = to_qstring(file.stem()) + '_';
  const QString extension = to_qstring(file.extension());
  std::vector<QString> present;
  std::error_code error;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const QString name = to_qstring(entry->path().filename());
    if (!name.startsWith(stem) || !name.endsWith(extension)) continue;
    const int digits = static_cast<int>(name.size() - stem.size() - extension.size());
    bool is_number = false;
    const int frame = name.mid(stem.size(), std::max(digits, 0)).toInt(&is_number);
    if (!is_number || frame < frames.first || frame > frames.second) continue;
    if (numbered_file(file, frame).filename() == entry->path().filename()) present.push_back(name);
  }
  std::sort(present.begin(), present.end());
  return present;
}

}  // namespace

QString last_folder(FileKind kind, const QString& fallback) {
  const QString last = QSettings().value(settings_key(kind)).toString();
  return !last.isEmpty() && QDir(last).exists() ? last : fallback;
}

void remember_folder(FileKind kind, const fs::path& file) {
  QSettings().setValue(settings_key(kind), to_qstring(fs::absolute(file).parent_path()));
}

fs::path ask_for_file(QWidget* window, FileKind kind, const QString& title, const QString& filter,
                      const QString& fallback) {
  const QString name =
      QFileDialog::getOpenFileName(window, title, last_folder(kind, fallback), filter);
  if (name.isEmpty()) return {};
  remember_folder(kind, to_path(name));
  return to_path(name);
}

bool may_replace(QWidget* window, const fs::path& file,
                 const std::optional<std::pair<int, int>>& frames) {
  std::vector<QString> present;
  std::error_code error;
  if (frames) {
    present = present_frames(file, *frames);
  } else if (fs::exists(file, error)) {
    present = {to_qstring(file.filename())};
  }
  if (present.empty()) return true;
  const QString text = present.size() == 1
                           ? dialog_text("“%1” already exists. Replace it?").arg(present.front())
                           : dialog_text("%n file(s) already exist, “%1” to “%2”. Replace them?",
                                         static_cast<int>(present.size()))
                                 .arg(present.front(), present.back());
  return ask(window, dialog_text("Replace Files"), text,
             {{QMessageBox::Cancel}, {QMessageBox::Yes, dialog_text("Replace")}}) ==
         QMessageBox::Yes;
}

}  // namespace brume
