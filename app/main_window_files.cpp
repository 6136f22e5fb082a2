// What goes out of the window into files, and what is dropped onto it.

#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QMimeData>

#include "app/animation_dialog.h"
#include "app/document/paths.h"
#include "app/frame_export.h"
#include "app/import/scene_import.h"
#include "app/main_window.h"
#include "app/medium_dialog.h"
#include "app/scene_files.h"
#include "app/timeline.h"
#include "app/viewport/view_grid.h"
#include "core/io/file_bytes.h"
#include "core/io/gather.h"

namespace brume {
namespace {

bool is_scene(const std::filesystem::path& file) {
  return lower_case_extension(file) == ".brume";
}

// The first dropped file that can be opened or imported; of several the first may be a frame.
std::filesystem::path dropped_file(const QMimeData& data) {
  for (const QUrl& url : data.urls()) {
    const std::filesystem::path file = to_path(url.toLocalFile());
    if (is_scene(file) || SceneImport::can_import(file)) return file;
  }
  return {};
}

}  // namespace

void MainWindow::export_frame() {
  QFileDialog dialog(this, tr("Export frame"), {},
                     tr("PNG picture (*.png);;OpenEXR layers (*.exr)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("png");
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.contains("exr") ? "exr" : "png");
  });
  if (dialog.exec() == QDialog::Accepted) export_frame_to(to_path(dialog.selectedFiles().value(0)));
}

void MainWindow::export_frame_to(const std::filesystem::path& file) {
  frame_export_->start(export_request(file));
}

void MainWindow::export_animation() {
  const QString folder =
      document_.file().empty() ? QDir::homePath() : to_qstring(document_.file().parent_path());
  auto* dialog = new AnimationDialog(*timeline_, folder, this);
  connect(dialog, &AnimationDialog::wanted, this, &MainWindow::export_animation_to);
  dialog->show();
}

void MainWindow::export_animation_to(const std::filesystem::path& file, int first, int last) {
  FrameExportRequest request = export_request(file);
  request.range = {first, last, Timeline::frames_per_second};
  if (document_.scene().camera_keys != CameraKeys{}) request.camera.reset();
  frame_export_->start(request);
}

FrameExportRequest MainWindow::export_request(const std::filesystem::path& file) const {
  const Settings settings = viewport_->quality().settings();
  return {document_.snapshot(),
          viewport_->camera(),
          settings,
          {document_.file().string(), to_string(settings.airlight), {}, viewport_->exposure()},
          views_->backend(),
          file,
          std::nullopt};
}

void MainWindow::export_medium() {
  auto* dialog = new MediumDialog(document_.snapshot(), *timeline_, folder(), this);
  connect(dialog, &MediumDialog::wanted, this, [this](const MediumExport& what) {
    const QString name = to_qstring(what.file.filename());
    start_file_job(tr("Exporting %1").arg(name), brume::export_medium(what));
  });
  dialog->show();
}

void MainWindow::gather() {
  QFileDialog dialog(this, tr("Gather into a new folder"), folder());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setLabelText(QFileDialog::FileName, tr("Folder"));
  if (dialog.exec() == QDialog::Accepted) gather_to(to_path(dialog.selectedFiles().value(0)));
}

void MainWindow::gather_to(const std::filesystem::path& folder) {
  const std::string name =
      document_.file().empty() ? std::string("scene") : document_.file().stem().string();
  start_file_job(tr("Gathering"),
                 [this, folder, name,
                  scene = document_.scene_to_save()](const Job& job) -> BackgroundJob::Take {
                   gather_scene(scene, folder, name, job.stop);
                   return [this, folder] { say(tr("Gathered in %1").arg(to_qstring(folder))); };
                 });
}

void MainWindow::start_file_job(const QString& title, const BackgroundJob::Work& work) {
  if (!file_job_->start(title, work)) {
    say(tr("Something else is still being imported or exported."));
  }
}

QString MainWindow::folder() const {
  return document_.file().empty() ? QDir::homePath() : to_qstring(document_.file().parent_path());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!dropped_file(*event->mimeData()).empty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const std::filesystem::path file = dropped_file(*event->mimeData());
  if (is_scene(file)) {
    files_->open_file(file);
  } else if (event->mimeData()->urls().size() > 1) {
    import_->import_sequence(file);
  } else {
    import_->import_file(file);
  }
  event->acceptProposedAction();
}

}  // namespace brume
