#include "app/window/docks.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>
#include <QScrollArea>
#include <QStyle>
#include <QUndoView>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/assets/asset_panel.h"
#include "app/document/document.h"
#include "app/document/time/timeline.h"
#include "app/panels/forms/adjust_panel.h"
#include "app/panels/forms/emitter_panel.h"
#include "app/panels/forms/group_panel.h"
#include "app/panels/forms/key_button.h"
#include "app/panels/forms/light_panel.h"
#include "app/panels/forms/material_panel.h"
#include "app/panels/forms/medium_panel.h"
#include "app/panels/gaussians/gaussian_panel.h"
#include "app/panels/plots/contribution_panel.h"
#include "app/panels/plots/performance_panel.h"
#include "app/panels/time/curve_panel.h"
#include "app/panels/time/dope_sheet.h"
#include "app/panels/time/timeline_bar.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/rows.h"
#include "app/window/file_jobs.h"
#include "app/window/frame_output.h"
#include "app/window/pages/message_bar.h"

namespace brume {
namespace {

// The undo history. Its current step is where the scene is, so that keys that search or go far
// would undo or redo many steps; the arrows go by one.
class HistoryView : public QUndoView {
 public:
  using QUndoView::QUndoView;
  void keyboardSearch(const QString& /*letters*/) override {}

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    constexpr std::array jumps{Qt::Key_Home, Qt::Key_End, Qt::Key_PageUp, Qt::Key_PageDown};
    if (std::ranges::find(jumps, event->key()) == jumps.end()) QUndoView::keyPressEvent(event);
  }
};

// A disk icon marks the saved state.
QUndoView* history_view(QUndoStack& stack) {
  auto* view = new HistoryView(&stack);
  const int size = view->fontMetrics().height();
  view->setIconSize({size, size});
  view->setUniformItemSizes(true);
  view->setEmptyLabel(QCoreApplication::translate("Docks", "As opened"));
  view->setCleanIcon(view->style()->standardIcon(QStyle::SP_DialogSaveButton));
  return view;
}

}  // namespace

Docks::Docks(const Workspace& work, FrameOutput& output, FileJobs& jobs, QMainWindow& window)
    : QObject(&window), work_(work), output_(output), window_(window) {
  add_scene_panels();
  add_frame_panels();
  for (SceneForm* form : window_.findChildren<SceneForm*>()) {
    connect(form, &SceneForm::refused, this, work_.show_status);
  }
  add_time_panels();
  add_assets(jobs);
  auto* adjust = new AdjustPanel(work_.document, &work_.views);
  connect(adjust, &AdjustPanel::refused, this, work_.show_status);
  on_change(work_.document, Change::object, this, [this] {
    const auto& object = work_.document.object();
    if (!object) return;
    const std::array panels{lights_, emitters_, surfaces_};  // by kind
    panels.at(static_cast<std::size_t>(object->kind))->raise();
  });
}

QDockWidget* Docks::add(const QString& title, const char* name, QWidget* panel) {
  auto* made = named(new QDockWidget(title, &window_), name);  // restoreState() knows it by this
  made->setWidget(panel);
  window_.addDockWidget(Qt::RightDockWidgetArea, made);
  return made;
}

void Docks::add_scene_panels() {
  Document& document = work_.document;
  ViewGrid& views = work_.views;
  auto* outliner = new Outliner(document, &window_);
  auto* gaussians = new GaussianPanel(document, &window_);
  auto* lights = new LightPanel(
      document, [&views]() -> const View& { return views.active(); }, &window_);
  auto* medium =
      new MediumPanel(document, views.perspective().frames().quality().scattering(), &window_);
  views.set_scattering(medium->scattering());
  connect(medium, &MediumPanel::scattering_changed, &views, &ViewGrid::set_scattering);
  connect(gaussians, &GaussianPanel::refused, this, work_.show_status);
  connect(outliner, &Outliner::asked_for, this, &Docks::show_panel_of);
  connect(outliner, &Outliner::look_through_asked, &views,
          [&views] { views.perspective().camera_controller().look_through_scene_camera(); });
  outliner_ = add(tr("Outliner"), "outliner", outliner);
  gaussians_ = add(tr("Gaussians"), "gaussians", scrolled(gaussians));
  lights_ = add(tr("Lighting"), "lighting", scrolled(lights));
  medium_ = add(tr("Medium"), "medium", scrolled(medium));
  surfaces_ = add(tr("Surface"), "material", scrolled(new MaterialPanel(document, &window_)));
  emitters_ = add(tr("Emitters"), "emitters_dock", scrolled(new EmitterPanel(document, &window_)));
  groups_ = add(tr("Group"), "group_dock", scrolled(new GroupPanel(document, &window_)));
  window_.tabifyDockWidget(gaussians_, lights_);
  window_.tabifyDockWidget(lights_, medium_);
  window_.tabifyDockWidget(medium_, surfaces_);
  window_.tabifyDockWidget(surfaces_, emitters_);
  gaussians_->raise();
}

void Docks::add_frame_panels() {
  ViewGrid& views = work_.views;
  QDockWidget* history = add(tr("History"), "history", history_view(work_.document.undo_stack()));
  auto* performance_panel =
      new PerformancePanel([&views]() -> const FrameScheduler& { return views.active().frames(); });
  views.set_max_error(performance_panel->max_error());
  connect(performance_panel, &PerformancePanel::max_error_changed, &views,
          &ViewGrid::set_max_error);
  for (const auto signal :
       {&ViewGrid::frame_shown, &ViewGrid::active_changed, &ViewGrid::mode_changed}) {
    connect(&views, signal, performance_panel, &PerformancePanel::update_frame);
  }
  connect(&views, &ViewGrid::error_changed, performance_panel, &PerformancePanel::update_quality);
  QDockWidget* performance = add(tr("Performance"), "performance", scrolled(performance_panel));
  auto* contribution_panel = new ContributionPanel(work_.document, &window_);
  connect(&views, &ViewGrid::pointed_at, contribution_panel, &ContributionPanel::inspect);
  QDockWidget* at_cursor = add(tr("At the Cursor"), "at_cursor", scrolled(contribution_panel));
  window_.tabifyDockWidget(performance, history);
  window_.tabifyDockWidget(performance, at_cursor);
  window_.tabifyDockWidget(performance, groups_);
  output_.add_docks(at_cursor);
  performance->raise();
  window_.resizeDocks({gaussians_}, {400}, Qt::Horizontal);
  window_.resizeDocks({outliner_, gaussians_, performance}, {150, 420, 170}, Qt::Vertical);
}

// An asset that is added without the mouse goes to the middle of the view.
void Docks::add_assets(FileJobs& jobs) {
  auto* assets = new AssetPanel(work_.document, work_.tools, &window_);
  connect(assets, &AssetPanel::add_asked, &jobs, [this, &jobs](const std::filesystem::path& file) {
    Viewport& view = work_.views.active();
    jobs.add_asset(file, view, QRectF(view.rect()).center());
  });
  connect(assets, &AssetPanel::told, this, work_.show_status);
  connect(assets, &AssetPanel::refused, &work_.messages, &MessageBar::show_error);
  QDockWidget* dock = add(tr("Assets"), "assets_dock", assets);
  window_.tabifyDockWidget(groups_, dock);
  dock->hide();  // the tabs beside it have no room for another one
}

void Docks::add_time_panels() {
  ViewGrid& views = work_.views;
  auto* timeline = named(new QDockWidget(tr("Timeline"), &window_), "timeline");
  timeline_bar_ = new TimelineBar(
      work_.timeline, work_.document, [&views] { return views.perspective().camera(); }, &window_);
  timeline->setWidget(timeline_bar_);
  connect(&views, &ViewGrid::frame_shown, timeline_bar_, [this] {
    if (const RenderedFrame* frame = work_.views.active().frames().shown()) {
      timeline_bar_->picture_shown(frame->request.time);
    }
  });
  const auto show_cached = [this] {
    timeline_bar_->show_cached(work_.views.picture_cache(),
                               static_cast<int>(work_.views.active().projection()));
  };
  connect(&views.picture_cache(), &PictureCache::changed, timeline_bar_, show_cached);
  connect(&views, &ViewGrid::active_changed, timeline_bar_, show_cached);
  window_.addDockWidget(Qt::BottomDockWidgetArea, timeline);
  auto* curves = named(new QDockWidget(tr("Curves"), &window_), "curves_dock");
  auto* curve_panel = new CurvePanel(work_.timeline, work_.document, &window_);
  curves->setWidget(curve_panel);
  window_.addDockWidget(Qt::BottomDockWidgetArea, curves);
  window_.splitDockWidget(curves, timeline, Qt::Vertical);
  curves->hide();
  connect(timeline_bar_, &TimelineBar::refused, this, work_.show_status);
  const auto show_curves = [this, curves, timeline, curve_panel] {
    const int height = timeline->height();
    curves->show();
    window_.resizeDocks({curves, timeline}, {240, height}, Qt::Vertical);
    curve_panel->show_tracks(timeline_bar_->sheet().chosen());
  };
  connect(timeline_bar_, &TimelineBar::curves_asked_for, curves,
          [curves, show_curves] { curves->isHidden() ? show_curves() : curves->hide(); });
  DopeSheet& sheet = timeline_bar_->sheet();
  connect(&sheet, &DopeSheet::curves_asked_for, curves, show_curves);
  connect(&sheet, &DopeSheet::chosen_changed, curve_panel,
          [curve_panel, &sheet] { curve_panel->show_tracks(sheet.chosen()); });
  for (KeyButton* button : window_.findChildren<KeyButton*>()) {
    connect(button, &KeyButton::time_asked_for, &work_.timeline, [this](double time) {
      // The frame is the one farther from now, or the same key would be found again.
      constexpr double slack = 1e-6;  // frames, of rounding
      const double frame = work_.timeline.frame_of(time);
      work_.timeline.set_frame(static_cast<int>(
          time > work_.timeline.time() ? std::ceil(frame - slack) : std::floor(frame + slack)));
    });
    connect(button, &KeyButton::curve_asked_for, curves, [curves, curve_panel](const Track& track) {
      curves->show();
      curve_panel->show_tracks(std::span(&track, 1));
    });
  }
}

void Docks::show_panel_of(Outliner::Kind kind, std::size_t index) {
  using Kind = Outliner::Kind;
  if (kind == Kind::spline) return work_.tools.activate("spline");
  if (kind == Kind::camera) return output_.show_camera(index);
  if (kind == Kind::light) work_.document.set_active_light(index);
  const bool is_surface = kind == Kind::surface || kind == Kind::node;
  QDockWidget* panel = kind == Kind::gaussians ? gaussians_
                       : kind == Kind::group   ? groups_
                       : kind == Kind::medium  ? medium_
                       : is_surface            ? surfaces_
                       : kind == Kind::emitter ? emitters_
                                               : lights_;
  panel->show();
  panel->raise();
}

}  // namespace brume
