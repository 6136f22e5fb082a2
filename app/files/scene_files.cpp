#include "app/files/scene_files.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>
#include <exception>

#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/files/file_dialogs.h"
#include "app/files/recent_pictures.h"
#include "app/files/scene_load.h"
#include "app/widgets/field_filter.h"
#include "app/widgets/question.h"
#include "core/io/frame_pattern.h"

namespace brume {
namespace {

constexpr int max_recent = 10;
constexpr const char* recent_key = "recent_files";

QString filter() {
  return SceneFiles::tr("Brume scenes (*.brume);;All files (*)");
}

}  // namespace

SceneFiles::SceneFiles(Document& document, QWidget* window)
    : QObject(window), document_(document), window_(window) {
  connect(&loading_, &BackgroundJob::failed, this, &SceneFiles::failed);
  on_change(document_, Change::file, this, &SceneFiles::watch_folder);
  connect(&folder_watcher_, &QFileSystemWatcher::directoryChanged, this, [this] {
    if (lacks_file() != document_.is_file_missing()) check_file_version();
  });
}

bool SceneFiles::create() {
  if (!may_discard()) return false;
  loading_.cancel();
  document_.create();
  return true;
}

void SceneFiles::open() {
  const std::filesystem::path file =
      ask_for_file(window_, FileKind::scene, tr("Open Scene"), filter(), document_.folder());
  if (!file.empty()) open_file(file);
}

void SceneFiles::open_file(const std::filesystem::path& file) {
  if (!may_discard()) return;
  discard_revision_ = document_.revision();
  restoring_.reset();
  load(file);
}

void SceneFiles::open_copy(const std::filesystem::path& file) {
  if (!may_discard()) return;
  discard_revision_ = document_.revision();
  restoring_.reset();
  load(file);
  is_copy_ = true;
}

void SceneFiles::restore(const RecoveryFile& work) {
  if (!may_discard()) return;
  discard_revision_ = document_.revision();
  restoring_ = work;
  load(work.scene);
}

void SceneFiles::load(const std::filesystem::path& file, const FoundFiles& found) {
  is_copy_ = false;
  const auto work = [this, file, found](const Job&) {
    return
        [this, loaded = std::make_shared<LoadedScene>(read_scene(file, found))] { adopt(*loaded); };
  };
  loading_.start(work, tr("Opening %1").arg(to_qstring(file.filename())));
}

void SceneFiles::adopt(LoadedScene& loaded) {
  commit_typing();
  // Changes made meanwhile need a new question.
  if (document_.revision() != discard_revision_ && !may_discard()) return;
  version_check_.cancel();
  other_version_.reset();
  missing_ = loaded.missing.missing;
  const std::optional<RecoveryFile> work = std::exchange(restoring_, std::nullopt);
  const bool is_copy = std::exchange(is_copy_, false);
  if (is_copy) {
    document_.open(std::move(loaded.document), {});
  } else if (work) {
    document_.open_unsaved(std::move(loaded.document), work->file, work->version);
  } else if (!loaded.missing.found.empty()) {
    document_.open_unsaved(std::move(loaded.document), loaded.file, loaded.version);
  } else {
    document_.open(std::move(loaded.document), loaded.file, loaded.version);
  }
  if (!work && !is_copy) remember(loaded.file);
  if (!missing_.empty()) {
    QStringList names;
    for (const std::filesystem::path& file : missing_) names << to_qstring(file.filename());
    Q_EMIT opened_without(names, loaded.warnings);
  } else if (!loaded.warnings.isEmpty()) {
    Q_EMIT warned(loaded.warnings);
  }
  if (work) {
    Q_EMIT restored(*work);
  } else {
    Q_EMIT opened();
  }
}

bool SceneFiles::save() {
  commit_typing();
  if (document_.file().empty()) return save_as();
  switch (may_replace()) {
    case Replace::yes:
      return save_to(document_.file());
    case Replace::elsewhere:
      return save_as();
    case Replace::no:
      break;
  }
  return false;
}

SceneFiles::Replace SceneFiles::may_replace() {
  if (!document_.file_version()) return Replace::yes;
  const std::optional<FileVersion> present = FileVersion::read(document_.file());
  if (!present || present == document_.file_version()) return Replace::yes;
  const auto answer =
      ask(window_, tr("Changed on Disk"),
          tr("“%1” has been changed by another program. Overwriting it discards that change.")
              .arg(document_.name()),
          {{QMessageBox::Cancel},
           {QMessageBox::Save, tr("Overwrite")},
           {QMessageBox::SaveAll, tr("Save As…")}});
  if (answer == QMessageBox::SaveAll) return Replace::elsewhere;
  return answer == QMessageBox::Save ? Replace::yes : Replace::no;
}

void SceneFiles::check_file_version() {
  if (!document_.file_version() || loading_.is_running()) return;
  version_check_.start([this, file = document_.file()](const Job&) {
    return [this, present = FileVersion::read(file)] {
      if (!present) return check_file_exists();
      if (present == document_.file_version()) return document_.set_file_missing(false);
      if (present == other_version_) return;
      other_version_ = present;
      Q_EMIT changed_on_disk();
    };
  });
}

bool SceneFiles::lacks_file() const {
  std::error_code error;
  return document_.file_version() && !std::filesystem::exists(document_.file(), error);
}

void SceneFiles::check_file_exists() {
  if (!lacks_file() || document_.is_file_missing()) return;
  document_.set_file_missing(true);
  Q_EMIT removed();
}

void SceneFiles::watch_folder() {
  if (const QStringList watched = folder_watcher_.directories(); !watched.isEmpty()) {
    folder_watcher_.removePaths(watched);
  }
  if (!document_.file().empty()) folder_watcher_.addPath(document_.folder());
}

void SceneFiles::reload() {
  if (!document_.file().empty()) open_file(document_.file());
}

void SceneFiles::ignore_file_change() {
  if (other_version_) document_.set_file_version(*other_version_);
}

void SceneFiles::find_missing() {
  if (missing_.empty()) return;
  const QString name = to_qstring(missing_.front().filename());
  const QString kind = to_qstring(missing_.front().extension());
  const std::filesystem::path found =
      ask_for_file(window_, FileKind::missing, tr("Find %1").arg(name),
                   tr("Files of this type (*%1);;All files (*)").arg(kind), document_.folder());
  if (found.empty()) return;
  FoundFiles files;
  for (const std::filesystem::path& file : missing_) {
    const bool is_sequence = FramePattern::is_pattern(file.filename().string());
    const std::filesystem::path there = found.parent_path() / file.filename();
    std::error_code error;
    if (file == missing_.front() && !is_sequence) {
      files[file] = found;
    } else if (is_sequence || std::filesystem::exists(there, error)) {
      files[file] = there;
    }
  }
  if (!may_discard() || document_.file().empty()) return;
  discard_revision_ = document_.revision();
  restoring_.reset();
  load(document_.file(), files);
}

bool SceneFiles::save_as() {
  const QString folder = document_.file().empty() ? last_folder(FileKind::scene, document_.folder())
                                                  : document_.folder();
  QFileDialog dialog(window_, tr("Save Scene As"), folder, filter());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("brume");
  dialog.selectFile(document_.file().empty() ? tr("untitled.brume") : document_.name());
  if (dialog.exec() != QDialog::Accepted) return false;
  return save_to(to_path(dialog.selectedFiles().value(0)));
}

bool SceneFiles::save_to(const std::filesystem::path& file) {
  version_check_.cancel();
  try {
    document_.save(file);
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
    return false;
  }
  remember(document_.file());
  return true;
}

bool SceneFiles::may_discard() {
  commit_typing();
  check_file_exists();
  if (!document_.is_modified()) return true;
  const QString question = lacks_file() ? tr("“%1” is missing on disk. Save the scene there again?")
                                        : tr("Save the changes to “%1”?");
  const auto answer = ask(window_, tr("Unsaved Changes"), question.arg(document_.name()),
                          {{QMessageBox::Save}, {QMessageBox::Discard}, {QMessageBox::Cancel}});
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

void SceneFiles::remember(const std::filesystem::path& file) {
  remember_folder(FileKind::scene, file);
  QSettings settings;
  QStringList recent = settings.value(recent_key).toStringList();
  const QString name = to_qstring(file);
  recent.removeAll(name);
  recent.prepend(name);
  settings.setValue(recent_key, QStringList(recent.mid(0, max_recent)));
}

QStringList SceneFiles::recent() {
  return QSettings().value(recent_key).toStringList();
}

void SceneFiles::fill_recent_menu(QMenu& menu) {
  menu.clear();
  for (const QString& name : recent()) {
    const QString text = QFileInfo(name).fileName().replace('&', "&&");
    QAction* action = menu.addAction(text, this, [this, name] { open_file(to_path(name)); });
    action->setStatusTip(name);
    action->setIcon(recent_picture(to_path(name)));
  }
  if (menu.isEmpty()) menu.addAction(tr("No scenes yet"))->setEnabled(false);
}

}  // namespace brume
