#include "app/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QScreen>
#include <QScrollArea>
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
#include "app/document/paths.h"
#include "app/document/timeline.h"
#include "app/export/frame_export.h"
#include "app/files/recent_pictures.h"
#include "app/files/scene_files.h"
#include "app/import/scene_import.h"
#include "app/jobs/background_job.h"
#include "app/jobs/job_bar.h"
#include "app/panels/contribution_panel.h"
#include "app/panels/emitter_panel.h"
#include "app/panels/gaussian_panel.h"
#include "app/panels/history_panel.h"
#include "app/panels/light_panel.h"
#include "app/panels/material_panel.h"
#include "app/panels/medium_panel.h"
#include "app/panels/outliner.h"
#include "app/panels/performance_panel.h"
#include "app/panels/timeline_bar.h"
#include "app/tools/tool_bars.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/plain_text.h"
#include "app/window/message_bar.h"
#include "app/window/recovery_bar.h"

namespace brume {
namespace {

constexpr int message_time = 6000;     // milliseconds
constexpr double max_exposure = 20.0;  // stops, either way

// To three digits: numbers that a user meets should be short.
double rounded(double value) {
  return QString::number(value, 'g', 3).toDouble();
}

std::filesystem::path recovery_folder() {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return to_path(data + "/recovery");
}

// Of the window at the very first start, with its frame inside the screen.
QSize first_size(const QScreen& screen, const QStyle& style) {
  constexpr int border = 8;
  const QSize frame(2 * border, 2 * border + style.pixelMetric(QStyle::PM_TitleBarHeight));
  return QSize(1280, 800).boundedTo(screen.availableSize() - frame);
}

// Panels that a small screen may be too low for.
QWidget* scrolled(QWidget* panel) {
  auto* area = new QScrollArea;
  area->setWidget(panel);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  return area;
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      files_(new SceneFiles(document_, this)),
      autosave_(new Autosave(document_, recovery_folder(), this)),
      message_bar_(new MessageBar(this)),
      views_(new ViewGrid(document_, this)),
      viewport_(&views_->perspective()),
      tools_(new ToolBox(document_, *views_, this)),
      timeline_(new Timeline(this)) {
  auto* center = new QWidget(this);
  auto* layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(message_bar_);
  layout->addWidget(new ToolOptions(*tools_, this));
  layout->addWidget(views_, 1);
  center->setFocusProxy(views_);
  setCentralWidget(center);
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);

  addToolBar(Qt::LeftToolBarArea, new ToolBar(*tools_, this));
  create_docks();
  create_status_bar();
  create_actions();
  connect_document();

  resize(first_size(*screen(), *style()));
  const QSettings settings;
  restoreGeometry(settings.value("window/geometry").toByteArray());
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

void MainWindow::create_docks() {
  const auto dock = [this](const QString& title, const char* name, QWidget* panel) {
    auto* made = new QDockWidget(title, this);
    made->setObjectName(name);  // restoreState() knows it by this
    made->setWidget(panel);
    addDockWidget(Qt::RightDockWidgetArea, made);
    return made;
  };
  auto* outliner = new Outliner(document_, this);
  auto* light_panel = new LightPanel(document_, *views_, this);
  auto* medium_panel = new MediumPanel(document_, this);
  auto* material_panel = new MaterialPanel(document_, this);
  auto* emitter_panel = new EmitterPanel(document_, this);
  gaussian_panel_ = new GaussianPanel(document_, this);
  QDockWidget* outline = dock(tr("Outliner"), "outliner", outliner);
  QDockWidget* gaussians = dock(tr("Gaussians"), "gaussians", scrolled(gaussian_panel_));
  QDockWidget* lights = dock(tr("Lighting"), "lighting", scrolled(light_panel));
  QDockWidget* medium = dock(tr("Medium"), "medium", scrolled(medium_panel));
  QDockWidget* material = dock(tr("Material"), "material", scrolled(material_panel));
  QDockWidget* emitters = dock(tr("Emitters"), "emitters_dock", scrolled(emitter_panel));
  QDockWidget* history = dock(tr("History"), "history", new HistoryPanel(document_.undo_stack()));
  QDockWidget* performance =
      dock(tr("Performance"), "performance", scrolled(new PerformancePanel(*views_)));
  tabifyDockWidget(gaussians, lights);
  tabifyDockWidget(lights, medium);
  tabifyDockWidget(medium, material);
  tabifyDockWidget(material, emitters);
  gaussians->raise();
  QDockWidget* at_cursor = dock(tr("At the Cursor"), "at_cursor",
                                scrolled(new ContributionPanel(document_, *views_, this)));
  tabifyDockWidget(performance, history);
  tabifyDockWidget(performance, at_cursor);
  performance->raise();
  resizeDocks({gaussians}, {400}, Qt::Horizontal);
  resizeDocks({outline, gaussians, performance}, {110, 400, 230}, Qt::Vertical);

  connect(gaussian_panel_, &GaussianPanel::refused, this, &MainWindow::show_status);
  for (SceneForm* form : findChildren<SceneForm*>()) {
    connect(form, &SceneForm::refused, this, &MainWindow::show_status);
  }
  auto* timeline_dock = new QDockWidget(tr("Timeline"), this);
  timeline_dock->setObjectName("timeline");
  timeline_bar_ = new TimelineBar(
      *timeline_, document_, [this] { return viewport_->camera(); }, this);
  timeline_dock->setWidget(timeline_bar_);
  addDockWidget(Qt::BottomDockWidgetArea, timeline_dock);

  connect(outliner, &Outliner::asked_for, this,
          [this, gaussians, lights, medium, material, emitters, material_panel](Outliner::Kind kind,
                                                                                std::size_t index) {
            using Kind = Outliner::Kind;
            if (kind == Kind::light) document_.set_active_light(index);
            if (kind == Kind::emitter) document_.set_active_emitter(index);
            if (kind == Kind::surface) material_panel->show_surface(index);
            QDockWidget* panel = kind == Kind::gaussians ? gaussians
                                 : kind == Kind::medium  ? medium
                                 : kind == Kind::surface ? material
                                 : kind == Kind::emitter ? emitters
                                                         : lights;
            panel->show();
            panel->raise();
          });
}

void MainWindow::create_status_bar() {
  hint_ = new PlainLabel(this);
  numbers_ = new PlainLabel(this);
  error_ = new PlainLabel(this);
  error_->setObjectName("error");
  error_->setToolTip(
      tr("Relative RMSE of the airlight against the reference, measured on this frame; grey while "
         "measuring"));
  quality_ = new PlainLabel(this);
  quality_->setObjectName("quality");
  // Menu bars do not follow when what is in their corner grows.
  quality_->setMinimumWidth(quality_->fontMetrics().horizontalAdvance("reference 128 · < .01 %"));
  quality_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  quality_->setContentsMargins(0, 4, 8, 0);
  menuBar()->setCornerWidget(quality_);
  frame_export_ = new FrameExport(this);
  file_job_ = new BackgroundJob(BackgroundJob::Policy::one_at_a_time, this);
  import_ = new SceneImport(document_, *file_job_, this);
  connect(file_job_, &BackgroundJob::cancelled, this, [this] { show_status(tr("Cancelled")); });
  connect(file_job_, &BackgroundJob::failed, message_bar_, &MessageBar::show_error);
  connect(import_, &SceneImport::failed, message_bar_, &MessageBar::show_error);
  connect(&document_, &Document::refused, message_bar_, &MessageBar::show_error);
  statusBar()->addWidget(hint_, 1);
  for (BackgroundJob* job :
       {&files_->loading(), &views_->transfer_job().job(), &frame_export_->job(), file_job_}) {
    statusBar()->addPermanentWidget(new JobBar(*job));
  }
  statusBar()->addPermanentWidget(numbers_);
  statusBar()->addPermanentWidget(error_);
  connect(frame_export_, &FrameExport::finished, this,
          [this](const QString& file) { show_status(tr("Exported %1").arg(file)); });
  connect(frame_export_, &FrameExport::cancelled, this, [this](int written) {
    show_status(written == 0 ? tr("Export cancelled")
                             : tr("Export cancelled after %1 files").arg(written));
  });
  connect(frame_export_, &FrameExport::failed, message_bar_, &MessageBar::show_error);
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
  // Saved, or another scene.
  connect(&document_, &Document::file_changed, message_bar_, [this] {
    if (message_bar_->findChild<QWidget*>("reload")) message_bar_->hide();
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
  connect(&views_->transfer_job(), &TransferJob::warned, message_bar_, &MessageBar::show_note);
  connect(&views_->transfer_job().job(), &BackgroundJob::failed, message_bar_,
          &MessageBar::show_error);
  for (const auto signal : {&ViewGrid::frame_shown, &ViewGrid::active_changed}) {
    connect(views_, signal, this, &MainWindow::update_status);
    connect(views_, signal, this, &MainWindow::update_error);
    connect(views_, signal, this, &MainWindow::show_fallback);
  }
  connect(views_, &ViewGrid::error_changed, this, &MainWindow::update_error);
  connect(viewport_, &Viewport::frame_shown, this, &MainWindow::save_current_picture);
  connect(&document_, &Document::scene_replaced, message_bar_, [this] {
    message_bar_->hide();
    fallback_.clear();
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

void MainWindow::update_status() {
  const std::size_t count = document_.medium().size();
  const std::size_t selected = document_.selection().size();
  QString text = count == 1 ? tr("1 Gaussian") : tr("%1 Gaussians").arg(count_text(count));
  if (selected > 0) text += tr(", %1 selected").arg(count_text(selected));
  if (const RenderedFrame* frame = views_->active().shown()) {
    const bool gl = frame->frame.statistics.backend == "gl";
    text += tr(" · %1 ms%2 ·").arg(frame->milliseconds, 0, 'f', 1).arg(gl ? tr(", OpenGL") : "");
  }
  numbers_->setText(text);
  const bool is_select = tools_->active() == 0;
  hint_->setText(count == 0 && is_select ? tr("No fog yet. Press B to paint fog, or Shift+A to add "
                                              "a Gaussian at the centre of the view.")
                                         : tools_->tool().hint());
}

void MainWindow::update_error() {
  const Viewport& view = views_->active();
  const RenderedFrame* frame = view.shown();
  if (!frame) return;
  const FrameQuality& quality = view.quality();
  QString status = tr("measuring the error");
  QString corner = settings_text(frame->request.settings);
  if (const std::optional<ErrorEstimate>& error = quality.error()) {
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
  for (QLabel* label : {error_, quality_}) label->setEnabled(view.is_measured());
}

void MainWindow::show_fallback() {
  const RenderedFrame* frame = views_->active().shown();
  if (!frame) return;
  const QString why = fallback_text(frame->frame.statistics);
  if (why == fallback_) return;
  fallback_ = why;
  if (!why.isEmpty()) {
    message_bar_->show_note(tr("Rendered on the CPU instead of OpenGL: %1").arg(why));
  }
}

void MainWindow::show_time() {
  const bool looks_through_camera = viewport_->camera() == document_.scene().camera;
  views_->set_time(timeline_->time());
  document_.set_time(timeline_->time());
  if (looks_through_camera && viewport_->camera() != document_.scene().camera) {
    viewport_->set_camera(document_.scene().camera);
  }
}

void MainWindow::save_current_picture() {
  const RenderedFrame* frame = viewport_->shown();
  const std::filesystem::path& file = document_.file();
  if (!viewport_->is_settled() || file.empty() || document_.is_modified()) return;
  if (pictured_ == std::pair(file, document_.revision())) return;
  pictured_ = {file, document_.revision()};
  save_recent_picture(file, to_picture(frame->frame, viewport_->exposure(), ViewMode::final));
}

void MainWindow::show_status(const QString& message) {
  statusBar()->showMessage(message, message_time);
}

void MainWindow::add_gaussian_in_view() {
  const Viewport& view = views_->active();
  const double radius = rounded(0.12 * std::max(view.distance(), 1e-6));
  // Optical depth 1 through the center: sqrt(pi) * radius * density.
  const double density = rounded(1.0 / (std::sqrt(std::numbers::pi) * radius));
  add_gaussian(document_, {.center = view.camera().target, .radius = radius, .density = density});
}

void MainWindow::change_exposure(double stops) {
  Viewport& view = views_->active();
  view.set_exposure(std::clamp(view.exposure() + stops, -max_exposure, max_exposure));
  show_status(tr("Exposure %1 stops").arg(view.exposure(), 0, 'f', 1));
}

void MainWindow::quit_with_screenshot(const QString& file) {
  const auto take = [this, file] {
    if (!viewport_->is_measured() || files_->loading().is_running()) return;
    if (viewport_->transfer_job().job().is_running()) return;
    viewport_->quality().disconnect(this);
    // Once more through the event loop: all has come, but is not painted yet.
    QTimer::singleShot(200, this, [this, file] {
      const bool saved = grab().save(file);
      if (!saved) std::fprintf(stderr, "%s: cannot be written\n", qUtf8Printable(file));
      QApplication::exit(saved ? 0 : 1);
    });
  };
  connect(&viewport_->quality(), &FrameQuality::error_changed, this, take);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::ActivationChange && isActiveWindow()) files_->check_file_version();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->may_discard()) {
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
