#include "app/window/frame_output.h"

#include <QAction>
#include <QDockWidget>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>
#include <QSettings>
#include <QTabWidget>
#include <QVBoxLayout>

#include "app/commands/objects/edit_cameras.h"
#include "app/commands/objects/edit_output.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/document/text/number_text.h"
#include "app/document/time/timeline.h"
#include "app/export/queue_list.h"
#include "app/export/render_queue.h"
#include "app/files/file_dialogs.h"
#include "app/panels/forms/camera_panel.h"
#include "app/panels/forms/output_panel.h"
#include "app/viewport/camera_frame.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/keys.h"
#include "app/widgets/method_box.h"
#include "app/widgets/rows.h"
#include "app/window/camera_lock.h"
#include "app/window/file_jobs.h"
#include "app/window/pages/message_bar.h"
#include "app/window/picture_window.h"
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
  return scrolled(column);
}

QString region_text(const std::optional<QRectF>& region) {
  if (!region) return {};
  return FrameOutput::tr("Region: %1 × %2 % of the picture")
      .arg(fixed_text(100.0 * region->width(), 0), fixed_text(100.0 * region->height(), 0));
}

}  // namespace

FrameOutput::FrameOutput(const Workspace& work, FileJobs& jobs, QMainWindow& window)
    : QObject(&window),
      work_(work),
      window_(window),
      queue_(new RenderQueue(kept_renders_folder(), &window)) {
  create_actions(jobs);
  create_camera_actions();
  const FrameExport& exporter = queue_->exporter();
  connect(&exporter, &FrameExport::finished, this, [this](const QString& file) {
    work_.show_status(file.isEmpty() ? tr("Rendered") : tr("Exported %1").arg(file));
  });
  connect(&exporter, &FrameExport::cancelled, this, [this](int written) {
    work_.show_status(written == 0 ? tr("Export cancelled")
                                   : tr("Export cancelled after %n file(s)", nullptr, written));
  });
  connect(&exporter, &FrameExport::failed, &work_.messages, &MessageBar::show_error);
  connect(queue_, &RenderQueue::refused, &work_.messages, &MessageBar::show_error);
  connect(&queue_->kept(), &KeptRenders::failed, &work_.messages, &MessageBar::show_note);
}

QAction* FrameOutput::make_action(const QString& text, const char* name, const QString& tip) {
  auto* action = named(new QAction(text, &window_), name);
  action->setShortcuts(keys_of(name));
  action->setToolTip(tip);
  return action;
}

void FrameOutput::create_actions(FileJobs& jobs) {
  const auto add = [this](const QString& text, const char* name, const QString& tip, auto react) {
    QAction* action = make_action(text, name, tip);
    connect(action, &QAction::triggered, this, react);
    return action;
  };
  actions_ = {
      add(tr("Render &Picture"), "render.picture",
          tr("Renders what the scene's camera sees now, or the view where the panel Output says "
             "so, into the picture viewer and the file (F12)"),
          [this] { render(false); }),
      add(tr("Render &Animation"), "render.animation",
          tr("Renders all frames of the timeline to the file (Ctrl+F12)"),
          [this] { render(true); }),
      add(tr("Render &Region…"), "render.region",
          tr("Drag over the part of the camera's picture that is to be rendered"),
          [this] { mark_region(); }),
      add(tr("&Whole Picture"), "render.whole", tr("Renders all of the picture again"),
          [this] { work_.views.perspective().camera_frame().set_region(std::nullopt); }),
  };
  viewer_action_ = make_action(tr("Picture &Viewer"), "render.viewer",
                               tr("Shows rendered pictures in a window of their own"));
  keep_action_ = make_action(tr("&Keep View"), "render.keep_view",
                             tr("Keeps what the view shows in a slot of the picture viewer"));
  pictures_ = new PictureWindow(work_, jobs, window_, viewer_action_, keep_action_);
  pictures_->add_actions({actions_[0], actions_[1]});
}

void FrameOutput::create_camera_actions() {
  QAction* frame =
      make_action(tr("Camera &Frame"), "view.camera_frame",
                  tr("Shows what the scene's camera will render when you look through it"));
  QAction* lock = make_action(tr("&Lock Camera to View"), "view.lock_camera",
                              tr("While you look through the scene's camera, navigation moves it"));
  for (QAction* toggle : {frame, lock}) toggle->setCheckable(true);
  CameraController& camera = work_.views.perspective().camera_controller();
  connect(frame, &QAction::toggled, &camera, &CameraController::set_frame_shown);
  connect(frame, &QAction::triggered, this, [](bool on) { QSettings().setValue(frame_key, on); });
  connect(lock, &QAction::toggled, &camera, &CameraController::set_locked);
  frame->setChecked(QSettings().value(frame_key, true).toBool());
  camera.set_frame_shown(frame->isChecked());
  camera_actions_ = {frame, lock};
  create_guide_actions();
  new CameraLock(work_.document, work_.views.perspective());
}

void FrameOutput::create_guide_actions() {
  CameraFrame& frame = work_.views.perspective().camera_frame();
  const auto add = [&](const QString& text, const char* name, const QString& tip,
                       bool CameraFrame::Guides::*guide) {
    QAction* action = make_action(text, name, tip);
    action->setCheckable(true);
    const QString key = QString(name).replace('.', '/');
    const auto show = [&frame, guide](bool on) {
      CameraFrame::Guides guides = frame.guides();
      guides.*guide = on;
      frame.set_guides(guides);
    };
    action->setChecked(QSettings().value(key, frame.guides().*guide).toBool());
    show(action->isChecked());
    connect(action, &QAction::toggled, this, [show, key](bool on) {
      show(on);
      QSettings().setValue(key, on);
    });
    guide_actions_ << action;
  };
  add(tr("&Thirds"), "view.thirds",
      tr("Lines at the thirds of the camera's picture, while you look through it"),
      &CameraFrame::Guides::thirds);
  add(tr("&Safe Areas"), "view.safe_areas",
      tr("The parts of the camera's picture where action (%1) and titles (%2) stay visible")
          .arg(percent_text(CameraFrame::action_side), percent_text(CameraFrame::title_side)),
      &CameraFrame::Guides::safe_areas);
  add(tr("&Plate"), "view.plate",
      tr("The photographed picture that the panel Camera has chosen, over the camera's picture"),
      &CameraFrame::Guides::plate);
  // Guides are drawn in the camera's frame.
  const CameraController& camera = work_.views.perspective().camera_controller();
  const auto enable = [this, &camera] {
    for (QAction* action : guide_actions_) action->setEnabled(camera.frame().has_value());
  };
  connect(&camera, &CameraController::moved, this, enable);
  enable();
}

QTabWidget* FrameOutput::make_tabs() {
  Viewport& view = work_.views.perspective();
  cameras_ = new CameraPanel(
      work_.document, [&view] { return view.camera(); }, &window_);
  for (QAction* action : camera_actions_) cameras_->add_toggle(action);
  connect(cameras_, &CameraPanel::look_through_asked_for, &view,
          [&view] { view.camera_controller().look_through_scene_camera(); });

  output_ = new OutputPanel(
      work_.document, work_.timeline, [&view] { return view.frames().exposure(); }, actions_[0],
      actions_[1], &window_);
  CameraFrame& frame = view.camera_frame();
  connect(output_, &OutputPanel::clear_region_asked_for, actions_[3], &QAction::trigger);
  connect(&frame, &CameraFrame::region_changed, output_,
          [&frame, this] { output_->show_region(region_text(frame.region())); });
  on_change(work_.document, Change::scene, &frame, [&frame] { frame.set_region(std::nullopt); });

  connect(&work_.timeline, &Timeline::frame_changed, cameras_,
          [this] { cameras_->show_frame(work_.timeline.frame()); });
  connect(cameras_, &CameraPanel::plate_changed, &frame, &CameraFrame::set_plate);

  auto* queue = new QueueList(*queue_, &window_);
  connect(queue, &QueueList::show_asked_for, this, &FrameOutput::show_render);
  auto* tabs = named(new QTabWidget, "output_tabs");
  tabs->setDocumentMode(true);
  tabs->addTab(scrolled_panel(output_), tr("Picture"));
  tabs->addTab(scrolled_panel(cameras_), tr("Camera"));
  tabs->addTab(queue, tr("Queue"));
  const auto count = [this, tabs] {
    const int left = queue_->unfinished() + queue_->stopped();
    tabs->setTabText(2, left == 0 ? tr("Queue") : tr("Queue (%1)").arg(left));
  };
  connect(queue_, &RenderQueue::changed, tabs, count);
  count();
  return tabs;
}

void FrameOutput::add_docks(QDockWidget* beside) {
  output_dock_ = new QDockWidget(tr("Output"), &window_);
  output_dock_->setObjectName("output_dock");
  tabs_ = make_tabs();
  output_dock_->setWidget(tabs_);
  window_.addDockWidget(Qt::RightDockWidgetArea, output_dock_);
  window_.tabifyDockWidget(beside, output_dock_);

  connect(queue_, &RenderQueue::rendered, this, [this](int id, const ExportedFrame& made) {
    const bool is_first = !pictures_->pictures().slot_of_job(id);
    const std::size_t slot = pictures_->pictures().keep_of_job(id, made.picture);
    if (is_first && id == shown_render_) pictures_->show_new(slot);
  });
}

void FrameOutput::fill_menu(QMenu& menu) {
  menu.addActions({actions_[0], actions_[1]});
  menu.addSeparator();
  menu.addActions({actions_[2], actions_[3]});
  menu.addSeparator();
  menu.addActions({viewer_action_, keep_action_});
}

FrameExportRequest FrameOutput::output_request(bool animation) const {
  const Scene& scene = work_.document.scene();
  const Output& output = scene.output;
  FrameExportRequest request = view_request(output.file);
  const bool renders_view = output_->renders_view();
  if (!renders_view) request.request.camera.reset();  // the scene's
  // The region is marked in the picture of the scene's camera.
  const auto& region = work_.views.perspective().camera_frame().region();
  if (region && !renders_view) {
    request.request.film = film_region(scene.film, {region->left(), region->top()},
                                       {region->right(), region->bottom()});
  }
  request.request.layers = output.layers;
  if (!is_deep_file(output.file)) {
    if (output.paths) {
      trace_paths(request.request, *output.paths, output.denoise);
    } else if (work_.views.perspective().frames().mode() == ViewMode::path_traced) {
      trace_paths(request.request, MethodBox::first_paths(Denoising::solved), Denoising::solved);
    }
  }
  request.info.bits = output_->png_bits();
  if (output.exposure) request.info.look.exposure = *output.exposure;
  const QString camera = renders_view ? tr("View") : QString::fromStdString(scene.camera_name);
  if (animation) {
    request.range = {work_.timeline.first(), work_.timeline.last(),
                     work_.timeline.frames_per_second()};
    request.title = camera;
    return request;
  }
  request.title = tr("%1, frame %2").arg(camera).arg(work_.timeline.frame());
  if (lower_case_extension(request.file) == ".mp4") {
    request.file.clear();  // a video of one picture is of no use
  }
  return request;
}

void FrameOutput::render(bool animation) {
  const FrameExportRequest request = output_request(animation);
  if (animation && request.file.empty()) {
    show_output();
    return work_.show_status(tr("An animation needs a file: name it in the panel Output."));
  }
  if (!queue_->may_write(request)) return;
  if (!request.file.empty() && !may_write(request.file, animation)) return;
  const int id = queue_->add(request);
  if (id == 0) return;
  shown_render_ = id;
  if (!animation) pictures_->show();
  work_.show_status(tr("Rendering in the background; see the queue in the panel Output"));
}

void FrameOutput::show_tab(int index) {
  output_dock_->show();
  output_dock_->raise();
  tabs_->setCurrentIndex(index);
}

void FrameOutput::show_camera(std::size_t place) {
  cameras_->show_camera(camera_names(work_.document.scene()).value(static_cast<int>(place)));
  show_tab(1);
}

void FrameOutput::show_output() {
  show_tab(0);
  auto* file = tabs_->findChild<QLineEdit*>("output_file");
  for (QWidget* area = file; area; area = area->parentWidget()) {
    if (auto* scroll = qobject_cast<QScrollArea*>(area)) scroll->ensureWidgetVisible(file);
  }
  file->setFocus();
  file->selectAll();
}

// Asks once in a session for each file; its folder is made.
bool FrameOutput::may_write(const std::filesystem::path& file, bool animation) {
  const bool is_numbered = animation && lower_case_extension(file) != ".mp4";
  const auto frames = is_numbered
                          ? std::optional(std::pair(work_.timeline.first(), work_.timeline.last()))
                          : std::nullopt;
  if (!rendered_files_.contains({file, animation}) && !may_replace(&window_, file, frames)) {
    return false;
  }
  rendered_files_.insert({file, animation});
  std::error_code error;  // what cannot be created cannot be written either, and is told then
  std::filesystem::create_directories(file.parent_path(), error);
  return true;
}

void FrameOutput::show_render(int id) {
  const auto slot = pictures_->pictures().slot_of_job(id);
  if (!slot) return work_.show_status(tr("Its slot has another picture by now."));
  pictures_->show_new(*slot);
  pictures_->show();
}

void FrameOutput::mark_region() {
  CameraController& camera = work_.views.perspective().camera_controller();
  for (QAction* action : camera_actions_) {
    if (action->objectName() == "view.camera_frame") action->setChecked(true);
  }
  if (!camera.looks_through_scene_camera()) camera.look_through_scene_camera();
  work_.views.perspective().camera_frame().start_marking();
}

FrameExportRequest FrameOutput::view_request(const std::filesystem::path& file) const {
  RenderRequest request = work_.views.perspective().frames().quality().request();
  // Only one of the views' methods makes deep frames.
  if (is_deep_file(file)) request.airlight = AirlightMethod::sliced;
  request.camera = work_.views.perspective().camera();
  request.time = work_.views.perspective().time();
  request.backend = work_.views.backend();
  DisplayLook look = work_.views.perspective().frames().display();
  look.plate.reset();  // plates are not rendered
  return {.scene = work_.document.snapshot(),
          .request = request,
          .info = {.scene = work_.document.file().string(), .look = look},
          .file = file,
          .range = std::nullopt,
          .title = tr("Frame %1").arg(work_.timeline.frame())};
}

}  // namespace brume
