#include "app/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/assets/asset_files.h"
#include "app/document/paths.h"
#include "app/document/time/timeline.h"
#include "app/export/queue_list.h"
#include "app/export/render_queue.h"
#include "app/files/recent_pictures.h"
#include "app/files/scene_files.h"
#include "app/tools/tool_bars.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/field_filter.h"
#include "app/widgets/interface_settings.h"
#include "app/widgets/keys.h"
#include "app/window/docks.h"
#include "app/window/file_jobs.h"
#include "app/window/file_messages.h"
#include "app/window/frame_output.h"
#include "app/window/menus/main_menu.h"
#include "app/window/menus/object_menu.h"
#include "app/window/pages/message_bar.h"
#include "app/window/pages/recovery_bar.h"
#include "app/window/pages/start_page.h"
#include "app/window/picture_window.h"
#include "app/window/saved_views.h"
#include "app/window/status_line.h"

namespace brume {
namespace {

constexpr int message_time = 6000;  // milliseconds

std::filesystem::path recovery_folder() {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return to_path(data + "/recovery");
}

// Where a window may be, with its frame inside the screen.
QRect room_on(const QScreen& screen, const QStyle& style) {
  constexpr int border = 8;
  const int title = style.pixelMetric(QStyle::PM_TitleBarHeight);
  return screen.availableGeometry().adjusted(border, border + title, -border, -border);
}

// Moves and shrinks a window that was left on a larger screen.
void fit_into(const QRect& room, QWidget& window) {
  if (window.isMaximized() || window.isFullScreen()) return;
  QRect place = window.geometry();
  place.setSize(place.size().boundedTo(room.size()));
  place.moveLeft(std::clamp(place.left(), room.left(), room.right() + 1 - place.width()));
  place.moveTop(std::clamp(place.top(), room.top(), room.bottom() + 1 - place.height()));
  window.setGeometry(place);
}

// Keeps a small picture of each scene as it is in its file, for the start page and the menu of
// recent files.
void keep_scene_pictures(const Document& document, const Viewport& view) {
  using Saved = std::pair<std::filesystem::path, std::uint64_t>;  // file and revision
  const FrameScheduler& frames = view.frames();
  QObject::connect(&frames, &FrameScheduler::frame_shown, &view,
                   [&document, &frames, saved = Saved()]() mutable {
                     const std::filesystem::path& file = document.file();
                     if (!frames.is_settled() || file.empty() || document.is_modified()) return;
                     if (frames.mode() == ViewMode::path_traced) return;  // noisy yet
                     const Saved now(file, document.revision());
                     if (std::exchange(saved, now) == now) return;
                     const DisplayLook look{frames.exposure(), nullptr};
                     save_recent_picture(file,
                                         to_picture(frames.shown()->frame, look, ViewMode::final));
                   });
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      files_(new SceneFiles(document_, this)),
      autosave_(new Autosave(document_, recovery_folder(), this)),
      message_bar_(new MessageBar(this)),
      views_(new ViewGrid(document_, this)),
      viewport_(&views_->perspective()),
      tools_(new ToolBox(
          document_, *viewport_, [this](Tool* tool) { views_->set_tool(tool); }, this)),
      timeline_(new Timeline(this)) {
  auto& settings = InterfaceSettings::instance();
  const auto limit_undo = [this, &settings] { document_.set_undo_limit(settings.undo_limit()); };
  connect(&settings, &InterfaceSettings::changed, this, limit_undo);
  settings.load();
  lay_out_center();
  const Workspace work = workspace();
  show_file_messages(work);
  addToolBar(Qt::LeftToolBarArea, new ToolBar(*tools_, this));
  file_jobs_ = new FileJobs(work, this);
  output_ = new FrameOutput(work, *file_jobs_, *this);
  auto* docks = new Docks(work, *output_, *file_jobs_, *this);
  follow_time();  // after the panels, which then have the scene whose time it is
  auto* status = new StatusLine(work, *this,
                                {&files_->loading(), &views_->transfer_job().job(),
                                 &output_->queue().exporter().job(), &file_jobs_->job()});
  connect(start_page_, &StartPage::covers, status, &StatusLine::hide_scene);
  new MainMenu(work,
               {.jobs = *file_jobs_,
                .output = *output_,
                .objects = *new ObjectMenu(work, *file_jobs_, *this),
                .start_page = *start_page_,
                .autosave = *autosave_,
                .timeline_bar = docks->timeline_bar()},
               *this);
  keep_scene_pictures(document_, *viewport_);
  on_change(document_, Change::file | Change::modified, this, &MainWindow::update_title);
  for (const ToolBox::Entry& entry : tools_->entries()) {
    connect(entry.tool.get(), &Tool::refused, this, work.show_status);
  }
  restore_layout();
  offer_recovery();
  viewport_->setFocus();
  update_title();
}

Workspace MainWindow::workspace() {
  return {.document = document_,
          .files = *files_,
          .timeline = *timeline_,
          .views = *views_,
          .tools = *tools_,
          .messages = *message_bar_,
          .show_status = [this](const QString& message) {
            statusBar()->showMessage(message, message_time);
          }};
}

void MainWindow::lay_out_center() {
  auto* center = new QWidget(this);
  auto* layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  bars_ = new QWidget(center);
  auto* column = new QVBoxLayout(bars_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(message_bar_);
  layout->addWidget(bars_);
  layout->addWidget(new ToolOptions(*tools_, this));
  layout->addWidget(views_, 1);
  center->setFocusProxy(views_);
  setCentralWidget(center);
  start_page_ = new StartPage(document_, *files_, *this, *bars_, *views_);
  new SavedViews(document_, *files_, *viewport_, this);
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
}

void MainWindow::restore_layout() {
  const QRect room = room_on(*screen(), *style());
  resize(QSize(1280, 800).boundedTo(room.size()));
  const QSettings settings;
  if (restoreGeometry(settings.value("window/geometry").toByteArray())) {
    fit_into(room_on(*screen(), *style()), *this);
  }
  restoreState(settings.value("window/state").toByteArray());
}

void MainWindow::keep_layout() {
  constexpr int interval = 2000;  // milliseconds
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &MainWindow::store_layout);
  timer->start(interval);
}

void MainWindow::store_layout() {
  if (!isVisible()) return;
  QSettings settings;
  const auto store = [&settings](const char* key, const QByteArray& value) {
    if (settings.value(key).toByteArray() != value) settings.setValue(key, value);
  };
  store("window/geometry", saveGeometry());
  store("window/state", saveState());
  output_->pictures().store_place();
}

void MainWindow::follow_time() {
  connect(timeline_, &Timeline::frame_changed, this, &MainWindow::show_time);
  on_change(document_, Change::scene, timeline_, [this] {
    timeline_->stop();
    timeline_->set_frame(0);
    timeline_->show_frames(std::nullopt);
    timeline_->follow(document_.scene());
  });
  on_change(document_, Change::part, timeline_, [this] { timeline_->follow(document_.scene()); });
}

// The views go before the document they show. Hidden first: a window that is still visible moves
// its focus about while it goes.
MainWindow::~MainWindow() {
  hide();
  document_.disconnect();
  document_.undo_stack().disconnect();
  delete tools_;
  delete takeCentralWidget();
  qDeleteAll(findChildren<QDockWidget*>());
}

void MainWindow::offer_recovery() {
  auto* bar = new RecoveryBar(this);
  qobject_cast<QVBoxLayout*>(bars_->layout())->insertWidget(0, bar);
  connect(bar, &RecoveryBar::restore, files_, &SceneFiles::restore);
  connect(files_, &SceneFiles::restored, this, [this](const RecoveryFile& work) {
    // The old copy goes only when there is one of this session.
    autosave_->save_soon();
    autosave_->wait();
    if (autosave_->has_copy()) Autosave::forget(work);
  });
  connect(autosave_, &Autosave::failed, message_bar_, &MessageBar::show_note);
  bar->offer(autosave_->recovery_files());
  if (output_->queue().items().empty()) return;
  const auto show_queue = [this] {
    start_page_->close_page();
    output_->show_queue();
  };
  message_bar_->show_offers(tr("Renders of an earlier session are not finished."),
                            {{tr("Show Queue"), "show_queue", show_queue}});
}

void MainWindow::update_title() {
  setWindowTitle(document_.name() + "[*] – Brume");
  setWindowModified(document_.is_modified());
}

void MainWindow::show_time() {
  const bool looks_through_camera = viewport_->camera() == document_.scene().camera;
  views_->hold_frames();
  views_->set_time(timeline_->time());
  document_.set_time(timeline_->time());
  if (looks_through_camera && viewport_->camera() != document_.scene().camera) {
    viewport_->camera_controller().set_camera(document_.scene().camera);
  }
  views_->release_frames();
}

void MainWindow::keep_unsaved_work() {
  commit_typing();
  files_->check_file_exists();
  autosave_->save_now();
}

void MainWindow::quit_with_screenshot(const QString& file) {
  const auto take = [this, file] {
    if (!viewport_->frames().is_measured() || files_->loading().is_running()) return;
    if (views_->transfer_job().job().is_running()) return;
    viewport_->frames().quality().disconnect(this);
    // Once more through the event loop: all has come, but is not painted yet.
    QTimer::singleShot(200, this, [this, file] {
      const bool saved = grab().save(file);
      if (!saved) std::fprintf(stderr, "%s: cannot be written\n", qUtf8Printable(file));
      QApplication::exit(saved ? 0 : 1);
    });
  };
  connect(&viewport_->frames().quality(), &FrameQuality::error_changed, this, take);
}

// Panels that float were shown before the window, which would cover them.
void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  QTimer::singleShot(0, this, [this] {
    for (QDockWidget* dock : findChildren<QDockWidget*>()) {
      if (dock->isFloating()) dock->raise();
    }
  });
}

// Shortcuts are Latin letters, which a keyboard of another script alone does not have.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  const auto latin = latin_key(*event);
  for (QAction* action : latin ? findChildren<QAction*>() : QList<QAction*>()) {
    if (!action->isEnabled() || !action->shortcuts().contains(QKeySequence(*latin))) continue;
    action->trigger();
    return;
  }
  QMainWindow::keyPressEvent(event);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::ActivationChange && isActiveWindow()) {
    files_->check_file_version();
    file_jobs_->check_imported();
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QMimeData& dragged = *event->mimeData();
  if (dragged.hasUrls() || dragged.hasFormat(asset_mime)) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  file_jobs_->drop(*event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_stop(output_->queue(), this) || !files_->may_discard()) {
    event->ignore();
    return;
  }
  store_layout();
  output_->pictures().close();
  autosave_->end();
  event->accept();
}

}  // namespace brume
