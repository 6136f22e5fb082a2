// What goes out of the window into files, and what is dropped onto it.

#include <QDropEvent>
#include <QFileDialog>
#include <QMimeData>

#include "app/document/paths.h"
#include "app/document/timeline.h"
#include "app/export/animation_dialog.h"
#include "app/export/frame_dialog.h"
#include "app/export/medium_dialog.h"
#include "app/export/render_queue.h"
#include "app/files/file_dialogs.h"
#include "app/files/scene_files.h"
#include "app/import/scene_import.h"
#include "app/viewport/view_grid.h"
#include "app/window/dialogs/simplify_dialog.h"
#include "app/window/dialogs/simplify_job.h"
#include "app/window/main_window.h"
#include "app/window/pages/message_bar.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/scene/gather.h"
#include "core/io/scene/scene_files.h"
#include "render/request.h"

namespace brume {
namespace {

bool is_scene(const std::filesystem::path& file) {
  return lower_case_extension(file) == ".brume";
}

}  // namespace

void MainWindow::export_frame() {
  const bool path_traced = viewport_->frames().mode() == ViewMode::path_traced;
  auto* dialog =
      new FrameDialog(document_.folder(), path_traced, document_.scene().output.layers, this);
  connect(dialog, &FrameDialog::requested, this, &MainWindow::export_frame_to);
  dialog->show();
}

void MainWindow::export_frame_to(const std::filesystem::path& file, std::optional<int> paths,
                                 const OutputLayers& layers, int bits) {
  FrameExportRequest request = export_request(file);
  request.request.layers = layers;
  request.info.bits = bits;
  if (paths) trace_paths(request.request, *paths);
  render_queue_->add(request);
}

void MainWindow::export_animation() {
  auto* dialog = new AnimationDialog(*timeline_, document_.folder(), this);
  connect(dialog, &AnimationDialog::requested, this, &MainWindow::export_animation_to);
  dialog->show();
}

void MainWindow::export_animation_to(const std::filesystem::path& file, int first, int last) {
  FrameExportRequest request = export_request(file);
  request.range = {first, last, timeline_->frames_per_second()};
  request.title = tr("View");
  if (document_.scene().camera_keys != CameraKeys{}) request.request.camera.reset();
  render_queue_->add(request);
}

FrameExportRequest MainWindow::export_request(const std::filesystem::path& file) const {
  RenderRequest request = viewport_->frames().quality().request();
  // Of the methods of views one makes deep frames.
  if (is_deep_file(file)) request.airlight = AirlightMethod::sliced;
  request.camera = viewport_->camera();
  request.time = viewport_->time();
  request.backend = views_->backend();
  return {.scene = document_.snapshot(),
          .request = request,
          .info = {.scene = document_.file().string(), .look = viewport_->frames().display()},
          .file = file,
          .range = std::nullopt,
          .title = tr("Frame %1").arg(timeline_->frame())};
}

void MainWindow::export_medium() {
  auto* dialog = new MediumDialog(document_.snapshot(), *timeline_, viewport_->frames().exposure(),
                                  document_.folder(), this);
  connect(dialog, &MediumDialog::requested, this, [this](const MediumExport& what) {
    const QString name = to_qstring(what.file.filename());
    start_file_job(tr("Exporting %1").arg(name), brume::export_medium(what));
  });
  dialog->show();
}

void MainWindow::gather() {
  QFileDialog dialog(this, tr("Gather into a new folder"),
                     last_folder(FileKind::gather, document_.folder()));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setLabelText(QFileDialog::FileName, tr("Folder"));
  if (dialog.exec() != QDialog::Accepted) return;
  const std::filesystem::path folder = to_path(dialog.selectedFiles().value(0));
  remember_folder(FileKind::gather, folder);
  gather_to(folder);
}

void MainWindow::gather_to(const std::filesystem::path& folder) {
  const std::string name =
      document_.file().empty() ? std::string("scene") : document_.file().stem().string();
  start_file_job(tr("Gathering"), [this, folder, name, from = to_path(document_.folder()),
                                   document = document_.document_to_save()](const Job& job) {
    gather_scene(document, folder, name, job.stop);
    QString text = tr("Gathered in %1").arg(to_qstring(folder));
    if (const auto others = static_cast<int>(files_outside(document, from).size())) {
      text += tr(", with %n file(s) from outside the scene's folder", nullptr, others);
    }
    return [this, text] { show_status(text); };
  });
}

void MainWindow::show_simplify() {
  auto* dialog = new SimplifyDialog(document_, this);
  connect(dialog, &SimplifyDialog::requested, this, [this](const SimplifyLimits& limits) {
    start_file_job(tr("Simplifying"), simplifying(document_, limits, [this](const QString& text) {
                     show_status(text);
                   }));
  });
  dialog->show();
}

void MainWindow::start_file_job(const QString& title, const BackgroundJob::Work& work) {
  if (!file_job_->start(work, title)) {
    show_status(tr("Another import or export is still running."));
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  std::vector<std::filesystem::path> files;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) {
      files.push_back(to_path(url.toLocalFile()));
    } else {
      message_bar_->show_error(tr("%1 is no file of this computer. Download it, and drop the file.")
                                   .arg(url.toDisplayString()));
    }
  }
  if (files.empty()) return;
  if (files.size() == 1 && is_scene(files.front())) {
    files_->open_file(files.front());
  } else {
    import_->import_files(files);
  }
  event->acceptProposedAction();
}

}  // namespace brume
