#include "app/window/picture_window.h"

#include <QAction>
#include <QFileDialog>
#include <QMainWindow>
#include <QSettings>
#include <QWindow>

#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/document/time/timeline.h"
#include "app/files/file_dialogs.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/frame_text.h"
#include "app/window/file_jobs.h"

namespace brume {
namespace {

constexpr const char* place_key = "viewer/geometry";

}  // namespace

PictureWindow::PictureWindow(const Workspace& work, FileJobs& jobs, QMainWindow& window,
                             QAction* show, QAction* keep)
    : QObject(&window), work_(work), jobs_(jobs), viewer_(new PictureViewer(&window)) {
  viewer_->setWindowFlags(Qt::Window);
  viewer_->setWindowTitle(tr("Picture Viewer"));
  viewer_->setAttribute(Qt::WA_QuitOnClose, false);
  if (!viewer_->restoreGeometry(QSettings().value(place_key).toByteArray())) {
    viewer_->resize(1000, 720);
  }
  viewer_->addActions({show, keep});
  show->setCheckable(true);
  connect(show, &QAction::triggered, this, [this, show](bool on) {
    if (!on && !viewer_->isMinimized()) return close();
    this->show();
    show->setChecked(true);
  });
  connect(keep, &QAction::triggered, this, &PictureWindow::keep_view);
  connect(viewer_, &PictureViewer::visibility_changed, this, [this, show](bool visible) {
    show->setChecked(visible);
    if (!visible) store_place();
  });
  connect(viewer_, &PictureViewer::keep_view_asked_for, this, &PictureWindow::keep_view);
  connect(viewer_, &PictureViewer::save_asked_for, this, &PictureWindow::save_picture);
}

// Without a transient parent it is not always above the editor.
void PictureWindow::show() {
  viewer_->setWindowState(viewer_->windowState() & ~Qt::WindowMinimized);
  viewer_->show();
  viewer_->windowHandle()->setTransientParent(nullptr);
  viewer_->raise();
  viewer_->activateWindow();
}

void PictureWindow::store_place() const {
  if (!viewer_->windowHandle()) return;  // it has never been shown
  QSettings settings;
  const QByteArray place = viewer_->saveGeometry();
  if (settings.value(place_key).toByteArray() != place) settings.setValue(place_key, place);
}

void PictureWindow::keep_view() {
  const FrameScheduler& frames = work_.views.active().frames();
  const RenderedFrame* shown = frames.shown();
  if (!shown || !frames.is_settled()) {
    return work_.show_status(tr("Wait until the picture is at rest, then keep it."));
  }
  QString details = picture_details(shown->frame, shown->request.settings, shown->milliseconds);
  const std::optional<FrameError>& error = frames.quality().error();
  if (frames.quality().is_measured() && error && frames.mode() != ViewMode::path_traced) {
    details += tr(" · error %1").arg(errors_text(*error));
  }
  const QString name = tr("View, frame %1").arg(work_.timeline.frame());
  DisplayLook look = frames.display();
  look.plate.reset();  // the picture's image shows the radiance that it keeps
  const std::size_t slot =
      viewer_->pictures().keep(make_picture(shown->frame, look, name, details));
  viewer_->show_new(slot);
  show();
  work_.show_status(tr("Kept in slot %1").arg(slot + 1));
}

void PictureWindow::save_picture(const std::shared_ptr<const Picture>& picture, const QString& name,
                                 const QString& note) {
  const QString start = last_folder(FileKind::picture, work_.document.folder()) + "/picture.png";
  const QString chosen =
      QFileDialog::getSaveFileName(viewer_, tr("Save Picture"), start, tr("PNG pictures (*.png)"));
  if (chosen.isEmpty()) return;
  std::filesystem::path file = to_path(chosen);
  if (file.extension().empty()) file += ".png";
  remember_folder(FileKind::picture, file);
  jobs_.start(tr("Saving %1").arg(to_qstring(file.filename())),
              [this, file, picture, name, note](const Job&) -> BackgroundJob::Apply {
                brume::save_picture(*picture, file, name, note);
                return [this, file] { work_.show_status(tr("Saved %1").arg(to_qstring(file))); };
              });
}

}  // namespace brume
