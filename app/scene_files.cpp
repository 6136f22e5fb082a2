#include "app/scene_files.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <exception>

#include "app/document/document.h"
#include "app/document/paths.h"

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
    : QObject(window), document_(document), window_(window) {}

bool SceneFiles::create() {
  if (!may_discard()) return false;
  document_.create();
  return true;
}

bool SceneFiles::open() {
  const QString name = QFileDialog::getOpenFileName(window_, tr("Open scene"),
                                                    folder_of(document_.file()), filter());
  return !name.isEmpty() && open_file(to_path(name));
}

bool SceneFiles::open_file(const std::filesystem::path& file) {
  if (!may_discard()) return false;
  QGuiApplication::setOverrideCursor(Qt::WaitCursor);
  std::vector<std::string> warnings;
  QString problem;
  try {
    document_.load(file, &warnings);
  } catch (const std::exception& error) {
    problem = QString::fromUtf8(error.what());
  }
  QGuiApplication::restoreOverrideCursor();
  if (!problem.isEmpty()) {
    Q_EMIT failed(problem);
    return false;
  }
  remember(document_.file());
  QStringList lines;
  for (const std::string& warning : warnings) lines << QString::fromStdString(warning);
  if (!lines.isEmpty()) Q_EMIT warned(lines.join('\n'));
  return true;
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
  }
  if (menu.isEmpty()) menu.addAction(tr("No scenes yet"))->setEnabled(false);
}

}  // namespace brume
