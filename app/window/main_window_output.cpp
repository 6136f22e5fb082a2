// What is rendered to files and pictures: cameras, the render queue, the picture viewer.

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QSettings>
#include <QTabWidget>
#include <QVBoxLayout>

#include "app/commands/edit_output.h"
#include "app/document/number_text.h"
#include "app/document/paths.h"
#include "app/document/timeline.h"
#include "app/export/queue_list.h"
#include "app/export/render_queue.h"
#include "app/files/file_dialogs.h"
#include "app/panels/forms/camera_panel.h"
#include "app/panels/forms/output_panel.h"
#include "app/pictures/picture_viewer.h"
#include "app/viewport/camera_frame.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/keys.h"
#include "app/widgets/question.h"
#include "app/window/camera_lock.h"
#include "app/window/main_window.h"
#include "core/io/disk/file_bytes.h"
#include "render/output/frame_file.h"
#include "render/request.h"

namespace brume {
namespace {

constexpr const char* frame_key = "view/camera_frame";

// At the top, with room below.
QScrollArea* scrolled_panel(QWidget* panel) {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(panel);
  layout->addStretch();
  auto* area = new QScrollArea;
  area->setWidget(column);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  return area;
}

QString region_text(const std::optional<QRectF>& region) {
  if (!region) return {};
  return MainWindow::tr("Region: %1 × %2 % of the picture")
      .arg(fixed_text(100.0 * region->width(), 0), fixed_text(100.0 * region->height(), 0));
}

}  // namespace

void MainWindow::create_output_actions() {
  const auto add = [this](const QString& text, const char* name, const QString& tip, auto react) {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    action->setShortcuts(keys_of(name));
    action->setToolTip(tip);
    connect(action, &QAction::triggered, this, react);
    return action;
  };
  output_actions_ = {
      add(tr("Render &Picture"), "render.picture",
          tr("Renders what the scene's camera sees now, into the picture viewer and the file "
             "(F12)"),
          [this] { render_output(false); }),
      add(tr("Render &Animation"), "render.animation",
          tr("Renders all frames of the timeline to the file (Ctrl+F12)"),
          [this] { render_output(true); }),
      add(tr("Render &Region…"), "render.region",
          tr("Drag over the part of the camera's picture that is to be rendered"),
          [this] { mark_region(); }),
      add(tr("&Whole Picture"), "render.whole", tr("Renders all of the picture again"),
          [this] { viewport_->camera_frame().set_region(std::nullopt); }),
      add(tr("&Keep View"), "render.keep_view",
          tr("Keeps what the view shows in a slot of the picture viewer"), [this] { keep_view(); }),
  };
  QAction* frame = add(tr("Camera &Frame"), "view.camera_frame",
                       tr("Shows what the scene's camera will render when you look through it"),
                       [](bool on) { QSettings().setValue(frame_key, on); });
  QAction* lock = add(tr("&Lock Camera to View"), "view.lock_camera",
                      tr("While you look through the scene's camera, navigation moves it"), [] {});
  for (QAction* toggle : {frame, lock}) toggle->setCheckable(true);
  CameraController& camera = viewport_->camera_controller();
  connect(frame, &QAction::toggled, &camera, &CameraController::set_frame_shown);
  connect(lock, &QAction::toggled, &camera, &CameraController::set_locked);
  frame->setChecked(QSettings().value(frame_key, true).toBool());
  camera.set_frame_shown(frame->isChecked());
  camera_actions_ = {frame, lock};
  new CameraLock(document_, *viewport_);
}

void MainWindow::create_output_docks(QDockWidget* beside) {
  create_output_actions();
  render_queue_ = new RenderQueue(this);
  auto* cameras = new CameraPanel(
      document_, [this] { return viewport_->camera(); }, this);
  for (QAction* action : camera_actions_) cameras->add_toggle(action);
  connect(cameras, &CameraPanel::look_through_asked_for, this,
          [this] { viewport_->camera_controller().look_through_scene_camera(); });

  auto* output = new OutputPanel(
      document_, *timeline_, [this] { return viewport_->frames().exposure(); }, output_actions_[0],
      output_actions_[1], this);
  CameraFrame& frame = viewport_->camera_frame();
  connect(output, &OutputPanel::clear_region_asked_for, output_actions_[3], &QAction::trigger);
  connect(&frame, &CameraFrame::region_changed, output,
          [&frame, output] { output->show_region(region_text(frame.region())); });
  connect(&document_, &Document::scene_replaced, &frame,
          [&frame] { frame.set_region(std::nullopt); });
  auto* queue = new QueueList(*render_queue_, this);
  auto* tabs = new QTabWidget;
  tabs->setObjectName("output_tabs");
  tabs->setDocumentMode(true);
  tabs->addTab(scrolled_panel(output), tr("Picture"));
  tabs->addTab(scrolled_panel(cameras), tr("Camera"));
  tabs->addTab(queue, tr("Queue"));
  auto* dock = new QDockWidget(tr("Output"), this);
  dock->setObjectName("output_dock");
  dock->setWidget(tabs);
  addDockWidget(Qt::RightDockWidgetArea, dock);
  tabifyDockWidget(beside, dock);
  connect(render_queue_, &RenderQueue::changed, tabs, [this, tabs] {
    const int unfinished = render_queue_->unfinished();
    tabs->setTabText(2, unfinished == 0 ? tr("Queue") : tr("Queue (%1)").arg(unfinished));
  });

  picture_viewer_ = new PictureViewer(this);
  auto* pictures = new QDockWidget(tr("Picture Viewer"), this);
  pictures->setObjectName("picture_viewer");
  pictures->setWidget(picture_viewer_);
  addDockWidget(Qt::RightDockWidgetArea, pictures);
  pictures->setFloating(true);
  pictures->resize(860, 680);
  pictures->hide();
  pictures->toggleViewAction()->setShortcuts(keys_of("render.viewer"));
  pictures->toggleViewAction()->setObjectName("render.viewer");
  connect(picture_viewer_, &PictureViewer::keep_view_asked_for, this, &MainWindow::keep_view);
  connect(picture_viewer_, &PictureViewer::save_asked_for, this, &MainWindow::save_kept_picture);
  connect(queue, &QueueList::show_asked_for, this, &MainWindow::show_render);
  connect(render_queue_, &RenderQueue::rendered, this, [this](int id, const ExportedFrame& made) {
    const std::size_t slot = picture_viewer_->pictures().keep_of_job(id, made.picture);
    if (id == shown_render_) picture_viewer_->show_new(slot);
  });
}

void MainWindow::fill_render_menu(QMenu* menu) {
  menu->addActions({output_actions_[0], output_actions_[1]});
  menu->addSeparator();
  menu->addActions({output_actions_[2], output_actions_[3]});
  menu->addSeparator();
  menu->addAction(findChild<QDockWidget*>("picture_viewer")->toggleViewAction());
  menu->addAction(output_actions_[4]);
}

FrameExportRequest MainWindow::output_request(bool animation) const {
  const Scene& scene = document_.scene();
  const Output& output = scene.output;
  FrameExportRequest request = export_request(output.file);
  request.request.camera.reset();  // the scene's
  if (const auto& region = viewport_->camera_frame().region()) {
    request.request.film = film_region(scene.film, {region->left(), region->top()},
                                       {region->right(), region->bottom()});
  }
  if (output.paths && !is_deep_file(output.file)) trace_paths(request.request, *output.paths);
  if (output.exposure) request.info.look.exposure = *output.exposure;
  request.request.layers = output.layers;
  const QString camera = QString::fromStdString(scene.camera_name);
  if (animation) {
    request.range = {timeline_->first(), timeline_->last(), timeline_->frames_per_second()};
    request.title = camera;
    return request;
  }
  request.title = tr("%1, frame %2").arg(camera).arg(timeline_->frame());
  if (lower_case_extension(request.file) == ".mp4") {
    request.file.clear();  // a video of one picture is of no use
  }
  return request;
}

void MainWindow::render_output(bool animation) {
  const FrameExportRequest request = output_request(animation);
  if (animation && request.file.empty()) {
    auto* output = findChild<QDockWidget*>("output_dock");
    output->show();
    output->raise();
    output->findChild<QTabWidget*>("output_tabs")->setCurrentIndex(0);
    output->findChild<QLineEdit*>("output_file")->setFocus();
    show_status(tr("An animation needs a file: name it in the panel Output."));
    return;
  }
  if (!request.file.empty()) {
    const bool is_numbered = animation && lower_case_extension(request.file) != ".mp4";
    const auto frames = is_numbered
                            ? std::optional(std::pair(timeline_->first(), timeline_->last()))
                            : std::nullopt;
    // Once in a session is enough for a file.
    if (!rendered_files_.contains({request.file, animation}) &&
        !may_replace(this, request.file, frames)) {
      return;
    }
    rendered_files_.insert({request.file, animation});
    std::error_code error;  // what cannot be created cannot be written either, and is told then
    std::filesystem::create_directories(request.file.parent_path(), error);
  }
  const int id = render_queue_->add(request);
  shown_render_ = id;
  if (!animation) show_picture_viewer();
  show_status(tr("Rendering in the background; see the queue in the panel Output"));
}

void MainWindow::show_picture_viewer() {
  auto* dock = findChild<QDockWidget*>("picture_viewer");
  constexpr QPoint inside(60, 90);
  if (dock->isFloating() && dock->pos().isNull()) dock->move(frameGeometry().topLeft() + inside);
  dock->show();
  dock->raise();
}

bool MainWindow::may_end_renders() {
  const int unfinished = render_queue_->unfinished();
  if (unfinished == 0) return true;
  const QString text = unfinished == 1
                           ? tr("A render is not finished. End it?")
                           : tr("%1 renders are not finished. End them?").arg(unfinished);
  return ask(this, tr("Unfinished renders"), text,
             {{QMessageBox::Cancel, tr("Keep Rendering")}, {QMessageBox::Yes, tr("End")}}) ==
         QMessageBox::Yes;
}

void MainWindow::show_render(int id) {
  const auto slot = picture_viewer_->pictures().slot_of_job(id);
  if (!slot) return show_status(tr("Its slot has another picture by now."));
  picture_viewer_->show_new(*slot);
  show_picture_viewer();
}

void MainWindow::keep_view() {
  const FrameScheduler& frames = views_->active().frames();
  const RenderedFrame* shown = frames.shown();
  if (!shown || !frames.is_settled()) {
    return show_status(tr("Wait until the picture is at rest, then keep it."));
  }
  QString details = picture_details(shown->frame, shown->request.settings, shown->milliseconds);
  const std::optional<ErrorEstimate>& error = frames.quality().error();
  if (frames.quality().is_measured() && error && frames.mode() != ViewMode::path_traced) {
    details += tr(" · error %1").arg(error_text(*error));
  }
  const QString name = tr("View, frame %1").arg(timeline_->frame());
  const std::size_t slot =
      picture_viewer_->pictures().keep(make_picture(shown->frame, frames.display(), name, details));
  picture_viewer_->show_new(slot);
  show_picture_viewer();
  show_status(tr("Kept in slot %1").arg(slot + 1));
}

void MainWindow::save_kept_picture(const std::shared_ptr<const Picture>& picture) {
  const QString start = last_folder(FileKind::picture, document_.folder()) + "/picture.png";
  const QString name =
      QFileDialog::getSaveFileName(this, tr("Save picture"), start, tr("PNG pictures (*.png)"));
  if (name.isEmpty()) return;
  std::filesystem::path file = to_path(name);
  if (file.extension().empty()) file += ".png";
  remember_folder(FileKind::picture, file);
  start_file_job(tr("Saving %1").arg(to_qstring(file.filename())),
                 [this, file, picture](const Job&) -> BackgroundJob::Apply {
                   save_picture(*picture, file);
                   return [this, file] { show_status(tr("Saved %1").arg(to_qstring(file))); };
                 });
}

void MainWindow::mark_region() {
  CameraController& camera = viewport_->camera_controller();
  for (QAction* action : camera_actions_) {
    if (action->objectName() == "view.camera_frame") action->setChecked(true);
  }
  if (!camera.looks_through_scene_camera()) camera.look_through_scene_camera();
  viewport_->camera_frame().start_marking();
}

}  // namespace brume
