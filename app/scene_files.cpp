#include "app/scene_files.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <exception>

#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/recent_pictures.h"
#include "app/scene_load.h"

namespace brume {
namespace {

constexpr int max_recent = 10;
constexpr const char* recent_key = "recent_files";

QString filter() {
  return SceneFiles::tr("Brume scenes (*.brume);;All files (*)");
}

QString folder_of(const std::filesystem::path& file) {
  return file.empty() ? QString() : to_qstring(file.parent_path());
}

}  // namespace

SceneFiles::SceneFiles(Document& document, QWidget* window)
    : QObject(window), document_(document), window_(window), loading_(new SceneLoad(window)) {
  connect(loading_, &SceneLoad::loaded, this,
          [this](const std::shared_ptr<LoadedScene>& loaded) { take(*loaded); });
  connect(loading_, &SceneLoad::failed, this, &SceneFiles::failed);
}

bool SceneFiles::create() {
  if (!may_discard()) return false;
  loading_->cancel();
  document_.create();
  return true;
}

void SceneFiles::open() {
  const QString name = QFileDialog::getOpenFileName(window_, tr("Open scene"),
                                                    folder_of(document_.file()), filter());
  if (!name.isEmpty()) open_file(to_path(name));
}

void SceneFiles::open_file(const std::filesystem::path& file) {
  if (!may_discard()) return;
  asked_at_ = document_.undo_stack().index();
  restoring_.reset();
  loading_->start(file);
}

void SceneFiles::restore(const LeftBehind& work) {
  if (!may_discard()) return;
  asked_at_ = document_.undo_stack().index();
  restoring_ = work;
  loading_->start(work.scene);
}

void SceneFiles::take(LoadedScene& loaded) {
  // What was done meanwhile has not been asked about.
  if (document_.undo_stack().index() != asked_at_ && !may_discard()) return;
  if (restoring_) {
    const LeftBehind work = *std::exchange(restoring_, std::nullopt);
    document_.open_unsaved(std::move(loaded.scene), work.file);
    Q_EMIT restored(work);
    return;
  }
  document_.open(std::move(loaded.scene), loaded.file);
  remember(loaded.file);
  if (!loaded.warnings.isEmpty()) Q_EMIT warned(loaded.warnings);
  Q_EMIT opened();
}

bool SceneFiles::save() {
  return document_.file().empty() ? save_as() : save_to(document_.file());
}

bool SceneFiles::save_as() {
  QFileDialog dialog(window_, tr("Save scene as"), folder_of(document_.file()), filter());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("brume");
  dialog.selectFile(document_.file().empty() ? tr("untitled.brume") : document_.name());
  if (dialog.exec() != QDialog::Accepted) return false;
  return save_to(to_path(dialog.selectedFiles().value(0)));
}

bool SceneFiles::save_to(const std::filesystem::path& file) {
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
  if (!document_.is_modified()) return true;
  const auto answer = QMessageBox::warning(
      window_, tr("Unsaved changes"), tr("Save the changes to “%1”?").arg(document_.name()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

void SceneFiles::remember(const std::filesystem::path& file) {
  QSettings settings;
  QStringList recent = settings.value(recent_key).toStringList();
  const QString name = to_qstring(file);
  recent.removeAll(name);
  recent.prepend(name);
  settings.setValue(recent_key, QStringList(recent.mid(0, max_recent)));
}

void SceneFiles::fill_recent_menu(QMenu& menu) {
  menu.clear();
  for (const QString& name : QSettings().value(recent_key).toStringList()) {
    const QString text = QFileInfo(name).fileName().replace('&', "&&");
    QAction* action = menu.addAction(text, this, [this, name] { open_file(to_path(name)); });
    action->setStatusTip(name);
    action->setIcon(recent_picture(to_path(name)));
  }
  if (menu.isEmpty()) menu.addAction(tr("No scenes yet"))->setEnabled(false);
}

}  // namespace brume
