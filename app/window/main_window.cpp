#include "app/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/commands/edit_medium.h"
#include "app/document/number_text.h"
#include "app/document/paths.h"
#include "app/document/timeline.h"
#include "app/files/recent_pictures.h"
#include "app/files/scene_files.h"
#include "app/import/imported_reload.h"
#include "app/jobs/background_job.h"
#include "app/tools/tool_bars.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/field_filter.h"
#include "app/widgets/interface_settings.h"
#include "app/widgets/keys.h"
#include "app/window/pages/message_bar.h"
#include "app/window/pages/recovery_bar.h"
#include "app/window/pages/start_page.h"
#include "app/window/saved_views.h"
#include "core/math/rounded.h"

namespace brume {
namespace {

constexpr int message_time = 6000;     // milliseconds
constexpr double max_exposure = 20.0;  // stops, either way

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
  InterfaceSettings::instance().load();
  auto* center = new QWidget(this);
  auto* layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(message_bar_);
  layout->addWidget(new ToolOptions(*tools_, this));
  layout->addWidget(views_, 1);
  center->setFocusProxy(views_);
  setCentralWidget(center);
  start_page_ = new StartPage(document_, *files_, *views_);
  new SavedViews(document_, *files_, *viewport_, this);
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);

  addToolBar(Qt::LeftToolBarArea, new ToolBar(*tools_, this));
  create_docks();
  create_status_bar();
  create_actions();
  connect_document();

  resize(QSize(1280, 800).boundedTo(room_on(*screen(), *style()).size()));
  const QSettings settings;
  if (restoreGeometry(settings.value("window/geometry").toByteArray())) {
    fit_into(room_on(*screen(), *style()), *this);
  }
  restoreState(settings.value("window/state").toByteArray());
  offer_recovery();
  viewport_->setFocus();
  update_title();
  update_status();
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

void MainWindow::connect_document() {
  const auto fail = [this](const QString& message) {
    std::fprintf(stderr, "%s\n", qUtf8Printable(message));
    message_bar_->show_error(message);
  };
  connect(files_, &SceneFiles::failed, this, fail);
  connect(&files_->loading(), &BackgroundJob::cancelled, this,
          [this] { show_status(tr("Not opened")); });
  connect(files_, &SceneFiles::warned, message_bar_, &MessageBar::show_note);
  connect(files_, &SceneFiles::changed_on_disk, this, [this] {
    message_bar_->show_offers(
        tr("“%1” has been changed by another program.").arg(document_.name()),
        {{tr("Reload"), "reload", [this] { files_->reload(); }},
         {tr("Keep Mine"), "keep_mine", [this] { files_->ignore_file_change(); }}});
  });
  connect(files_, &SceneFiles::removed, this, [this] {
    message_bar_->show_offers(
        tr("“%1” is missing: it was deleted, moved or renamed. The scene is unsaved until the file "
           "is back.")
            .arg(document_.name()),
        {{tr("Save"), "save_missing", [this] { files_->save(); }},
         {tr("Save As…"), "save_missing_as", [this] { files_->save_as(); }}});
  });
  // Saved, or another scene.
  connect(&document_, &Document::file_changed, message_bar_, [this] {
    if (message_bar_->findChild<QWidget*>("reload")) message_bar_->hide();
  });
  connect(&document_, &Document::modified_changed, message_bar_, [this] {
    if (document_.is_file_missing()) return;
    if (message_bar_->findChild<QWidget*>("save_missing")) message_bar_->hide();
  });
  const auto show_missing_files = [this](const QStringList& missing, const QString& warnings) {
    const QString text =
        tr("Missing files: %1. The scene is shown without them; saving keeps the references.")
            .arg(missing.join(", "));
    message_bar_->show_offers(warnings.isEmpty() ? text : text + '\n' + warnings,
                              {{tr("Find…"), "find_missing", [this] { files_->find_missing(); }}});
  };
  connect(files_, &SceneFiles::opened_without, this, show_missing_files);
  connect(views_, &ViewGrid::failed, this, fail);
  connect(views_, &ViewGrid::menu_asked, this, &MainWindow::show_view_menu);
  connect(&views_->transfer_job(), &TransferJob::warned, message_bar_, &MessageBar::show_note);
  connect(&views_->transfer_job().job(), &BackgroundJob::failed, message_bar_,
          &MessageBar::show_error);
  for (const auto signal : {&ViewGrid::frame_shown, &ViewGrid::active_changed}) {
    connect(views_, signal, this, &MainWindow::update_status);
    connect(views_, signal, this, &MainWindow::update_error);
    connect(views_, signal, this, &MainWindow::show_fallback);
    connect(views_, signal, this, &MainWindow::show_unreadable_frame);
  }
  connect(views_, &ViewGrid::error_changed, this, &MainWindow::update_error);
  connect(views_, &ViewGrid::mode_changed, this, &MainWindow::update_error);
  connect(&viewport_->frames(), &FrameScheduler::frame_shown, this,
          &MainWindow::save_current_picture);
  connect(&document_, &Document::scene_replaced, message_bar_, [this] {
    message_bar_->hide();
    fallback_.clear();
    unreadable_.clear();
  });
  connect(&document_, &Document::file_changed, this, &MainWindow::update_title);
  connect(&document_, &Document::medium_changed, this, &MainWindow::update_status);
  connect(&document_, &Document::selection_changed, this, &MainWindow::update_status);
  connect(&document_, &Document::modified_changed, this, &MainWindow::update_title);
  connect(timeline_, &Timeline::frame_changed, this, &MainWindow::show_time);
  connect(&document_, &Document::scene_replaced, timeline_, [this] {
    timeline_->stop();
    timeline_->set_frame(0);
    timeline_->follow(document_.scene());
  });
  connect(&document_, &Document::part_changed, timeline_,
          [this] { timeline_->follow(document_.scene()); });
  connect(tools_, &ToolBox::activated, this, &MainWindow::update_status);
  for (const ToolBox::Entry& entry : tools_->entries()) {
    connect(entry.tool.get(), &Tool::refused, this, &MainWindow::show_status);
  }
}

void MainWindow::offer_recovery() {
  auto* bar = new RecoveryBar(this);
  qobject_cast<QVBoxLayout*>(centralWidget()->layout())->insertWidget(0, bar);
  connect(bar, &RecoveryBar::restore, files_, &SceneFiles::restore);
  connect(files_, &SceneFiles::restored, this, [this](const RecoveryFile& work) {
    // The old copy goes only when there is one of this session.
    autosave_->save_soon();
    autosave_->wait();
    if (autosave_->has_copy()) Autosave::forget(work);
  });
  connect(autosave_, &Autosave::failed, message_bar_, &MessageBar::show_note);
  bar->offer(autosave_->recovery_files());
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

void MainWindow::save_current_picture() {
  const RenderedFrame* frame = viewport_->frames().shown();
  const std::filesystem::path& file = document_.file();
  if (!viewport_->frames().is_settled() || file.empty() || document_.is_modified()) return;
  if (viewport_->frames().mode() == ViewMode::path_traced) return;  // noisy yet
  if (pictured_ == std::pair(file, document_.revision())) return;
  pictured_ = {file, document_.revision()};
  save_recent_picture(
      file, to_picture(frame->frame, {viewport_->frames().exposure(), nullptr}, ViewMode::final));
}

void MainWindow::show_status(const QString& message) {
  statusBar()->showMessage(message, message_time);
}

void MainWindow::add_gaussian_in_view() {
  const Viewport& view = views_->active();
  const double radius = rounded(0.12 * std::max(view.distance(), 1e-6), 3);
  // Optical depth 1 through the center: sqrt(pi) * radius * density.
  const double density = rounded(1.0 / (std::sqrt(std::numbers::pi) * radius), 3);
  add_gaussian(document_, {.center = view.camera().target, .radius = radius, .density = density});
}

void MainWindow::change_exposure(double stops) {
  Viewport& view = views_->active();
  view.frames().set_exposure(
      std::clamp(view.frames().exposure() + stops, -max_exposure, max_exposure));
  show_status(tr("Exposure %1 stops").arg(fixed_text(view.frames().exposure(), 1)));
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
    imported_reload_->check();
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_end_renders() || !files_->may_discard()) {
    event->ignore();
    return;
  }
  QSettings settings;
  settings.setValue("window/geometry", saveGeometry());
  settings.setValue("window/state", saveState());
  autosave_->end();
  event->accept();
}

}  // namespace brume
