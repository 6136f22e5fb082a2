// What the window says of the scene, the frame and its error, and of background work.

#include <QLabel>
#include <QMenuBar>
#include <QStatusBar>

#include "app/document/number_text.h"
#include "app/export/render_queue.h"
#include "app/files/scene_files.h"
#include "app/import/imported_reload.h"
#include "app/import/scene_import.h"
#include "app/jobs/background_job.h"
#include "app/jobs/job_bar.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/viewport/viewport.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/plain_text.h"
#include "app/window/main_window.h"
#include "app/window/pages/light_new_scene.h"
#include "app/window/pages/message_bar.h"

namespace brume {

void MainWindow::create_status_bar() {
  hint_ = new PlainLabel(this);
  numbers_ = new PlainLabel(this);
  error_ = new PlainLabel(this);
  error_->setObjectName("error");
  error_->setToolTip(
      tr("Relative RMSE of the airlight against the reference, measured on this frame; grey while "
         "measuring. Of a path-traced picture: its noise, the standard error relative to the RMS"));
  quality_ = new PlainLabel(this);
  quality_->setObjectName("quality");
  // Menu bars do not follow when what is in their corner grows.
  quality_->setMinimumWidth(quality_->fontMetrics().horizontalAdvance("paper's method · < 0.01 %"));
  quality_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  quality_->setContentsMargins(0, 4, 8, 0);
  menuBar()->setCornerWidget(quality_);
  frame_export_ = &render_queue_->exporter();
  file_job_ = new BackgroundJob(BackgroundJob::Policy::one_at_a_time, this);
  import_ = new SceneImport(document_, *file_job_, this);
  imported_reload_ = new ImportedReload(document_, this);
  connect(file_job_, &BackgroundJob::cancelled, this, [this] { show_status(tr("Cancelled")); });
  connect(file_job_, &BackgroundJob::failed, message_bar_, &MessageBar::show_error);
  connect(import_, &SceneImport::failed, message_bar_, &MessageBar::show_error);
  connect(import_, &SceneImport::warned, message_bar_, &MessageBar::show_note);
  connect(imported_reload_, &ImportedReload::failed, message_bar_, &MessageBar::show_error);
  connect(imported_reload_, &ImportedReload::warned, message_bar_, &MessageBar::show_note);
  connect(import_, &SceneImport::surfaces_added, this,
          [this, framed = Camera{}]() mutable { light_new_scene(document_, *viewport_, framed); });
  connect(&document_, &Document::refused, message_bar_, &MessageBar::show_error);
  statusBar()->addWidget(hint_, 1);
  for (BackgroundJob* job :
       {&files_->loading(), &views_->transfer_job().job(), &frame_export_->job(), file_job_}) {
    statusBar()->addPermanentWidget(new JobBar(*job));
  }
  statusBar()->addPermanentWidget(numbers_);
  statusBar()->addPermanentWidget(error_);
  connect(frame_export_, &FrameExport::finished, this, [this](const QString& file) {
    show_status(file.isEmpty() ? tr("Rendered") : tr("Exported %1").arg(file));
  });
  connect(frame_export_, &FrameExport::cancelled, this, [this](int written) {
    show_status(written == 0 ? tr("Export cancelled")
                             : tr("Export cancelled after %1 files").arg(written));
  });
  connect(frame_export_, &FrameExport::failed, message_bar_, &MessageBar::show_error);
}

void MainWindow::update_status() {
  const std::size_t count = document_.medium().size();
  const std::size_t selected = document_.selection().size();
  QString text = count == 1 ? tr("1 Gaussian") : tr("%1 Gaussians").arg(count_text(count));
  if (selected > 0) text += tr(", %1 selected").arg(count_text(selected));
  if (const RenderedFrame* frame = views_->active().frames().shown()) {
    const bool gl = frame->frame.statistics.backend == "gl";
    text += tr(" · %1%2 ·").arg(duration_text(frame->milliseconds), gl ? tr(", OpenGL") : "");
  }
  numbers_->setText(text);
  const bool is_select = tools_->active() == 0;
  hint_->setText(count == 0 && is_select ? tr("No fog yet. Press B to paint fog, or Shift+A to add "
                                              "a Gaussian at the centre of the view.")
                                         : tools_->tool().hint());
}

void MainWindow::update_error() {
  const Viewport& view = views_->active();
  const RenderedFrame* frame = view.frames().shown();
  if (!frame) return;
  const FrameQuality& quality = view.frames().quality();
  QString status = tr("measuring the error");
  QString corner = settings_text(frame->request.settings);
  if (const QString paths = paths_text(frame->frame); !paths.isEmpty()) {
    status = paths;
    const std::optional<RelativeNoise> noise = relative_noise(frame->frame);
    if (noise) corner += " · " + percent_text(noise->picture);
  } else if (const std::optional<ErrorEstimate>& error = quality.error()) {
    status = tr("error %1").arg(error_text(*error));
    corner += " · " + percent_text(error->rel_rmse);
    if (quality.is_exhausted()) {
      const QString bound = bound_text(quality.max_error());
      status += quality.control().may_keep_bound() ? tr(", may exceed %1").arg(bound)
                                                   : tr(", cannot meet %1").arg(bound);
    }
  }
  error_->setText(status);
  quality_->setText(corner);
  for (QLabel* label : {error_, quality_}) label->setEnabled(view.frames().is_measured());
}

void MainWindow::show_fallback() {
  const RenderedFrame* frame = views_->active().frames().shown();
  // Paths are traced on the CPU by choice.
  if (!frame || frame->request.settings.airlight == AirlightMethod::path) return;
  const QString why = fallback_text(frame->frame.statistics);
  if (why == fallback_) return;
  fallback_ = why;
  if (!why.isEmpty()) {
    message_bar_->show_note(tr("Rendered on the CPU instead of OpenGL: %1").arg(why));
  }
}

// Once for each, however often it is played.
void MainWindow::show_unreadable_frame() {
  const QString& why = views_->active().problem();
  if (why.isEmpty() || why == unreadable_) return;
  unreadable_ = why;
  message_bar_->show_error(why);
}

}  // namespace brume
