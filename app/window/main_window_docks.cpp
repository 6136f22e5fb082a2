// The panels of the window, and what connects them to the views.

#include <QDockWidget>
#include <QScrollArea>
#include <array>

#include "app/panels/forms/emitter_panel.h"
#include "app/panels/forms/group_panel.h"
#include "app/panels/forms/light_panel.h"
#include "app/panels/forms/material_panel.h"
#include "app/panels/forms/medium_panel.h"
#include "app/panels/gaussians/gaussian_panel.h"
#include "app/panels/lists/history_panel.h"
#include "app/panels/lists/outliner.h"
#include "app/panels/plots/contribution_panel.h"
#include "app/panels/plots/performance_panel.h"
#include "app/panels/time/curve_panel.h"
#include "app/panels/time/timeline_bar.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/window/main_window.h"

namespace brume {
namespace {

// Panels that a small screen may be too low for.
QWidget* scrolled(QWidget* panel) {
  auto* area = new QScrollArea;
  area->setWidget(panel);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  return area;
}

}  // namespace

void MainWindow::create_docks() {
  const auto dock = [this](const QString& title, const char* name, QWidget* panel) {
    auto* made = new QDockWidget(title, this);
    made->setObjectName(name);  // restoreState() knows it by this
    made->setWidget(panel);
    addDockWidget(Qt::RightDockWidgetArea, made);
    return made;
  };
  auto* outliner = new Outliner(document_, this);
  auto* light_panel = new LightPanel(
      document_, [this]() -> const View& { return views_->active(); }, this);
  auto* medium_panel = new MediumPanel(document_, viewport_->frames().quality().scattering(), this);
  views_->set_scattering(medium_panel->scattering());
  connect(medium_panel, &MediumPanel::scattering_changed, views_, &ViewGrid::set_scattering);
  auto* material_panel = new MaterialPanel(document_, this);
  auto* emitter_panel = new EmitterPanel(document_, this);
  gaussian_panel_ = new GaussianPanel(document_, this);
  QDockWidget* outline = dock(tr("Outliner"), "outliner", outliner);
  QDockWidget* gaussians = dock(tr("Gaussians"), "gaussians", scrolled(gaussian_panel_));
  QDockWidget* lights = dock(tr("Lighting"), "lighting", scrolled(light_panel));
  QDockWidget* medium = dock(tr("Medium"), "medium", scrolled(medium_panel));
  QDockWidget* material = dock(tr("Surface"), "material", scrolled(material_panel));
  QDockWidget* emitters = dock(tr("Emitters"), "emitters_dock", scrolled(emitter_panel));
  QDockWidget* group = dock(tr("Group"), "group_dock", scrolled(new GroupPanel(document_, this)));
  QDockWidget* history = dock(tr("History"), "history", new HistoryPanel(document_.undo_stack()));
  auto* performance_panel =
      new PerformancePanel([this]() -> const FrameScheduler& { return views_->active().frames(); });
  views_->set_max_error(performance_panel->max_error());
  connect(performance_panel, &PerformancePanel::max_error_changed, views_,
          &ViewGrid::set_max_error);
  for (const auto signal :
       {&ViewGrid::frame_shown, &ViewGrid::active_changed, &ViewGrid::mode_changed}) {
    connect(views_, signal, performance_panel, &PerformancePanel::update_frame);
  }
  connect(views_, &ViewGrid::error_changed, performance_panel, &PerformancePanel::update_quality);
  QDockWidget* performance = dock(tr("Performance"), "performance", scrolled(performance_panel));
  tabifyDockWidget(gaussians, lights);
  tabifyDockWidget(lights, medium);
  tabifyDockWidget(medium, material);
  tabifyDockWidget(material, emitters);
  gaussians->raise();
  auto* contribution_panel = new ContributionPanel(document_, this);
  connect(views_, &ViewGrid::pointed_at, contribution_panel, &ContributionPanel::inspect);
  QDockWidget* at_cursor = dock(tr("At the Cursor"), "at_cursor", scrolled(contribution_panel));
  tabifyDockWidget(performance, history);
  tabifyDockWidget(performance, at_cursor);
  tabifyDockWidget(performance, group);
  create_output_docks(at_cursor);
  performance->raise();
  resizeDocks({gaussians}, {400}, Qt::Horizontal);
  resizeDocks({outline, gaussians, performance}, {150, 420, 170}, Qt::Vertical);

  connect(gaussian_panel_, &GaussianPanel::refused, this, &MainWindow::show_status);
  for (SceneForm* form : findChildren<SceneForm*>()) {
    connect(form, &SceneForm::refused, this, &MainWindow::show_status);
  }
  auto* timeline_dock = new QDockWidget(tr("Timeline"), this);
  timeline_dock->setObjectName("timeline");
  timeline_bar_ = new TimelineBar(
      *timeline_, document_, [this] { return viewport_->camera(); }, this);
  timeline_dock->setWidget(timeline_bar_);
  connect(views_, &ViewGrid::frame_shown, timeline_bar_, [this] {
    if (const RenderedFrame* frame = views_->active().frames().shown()) {
      timeline_bar_->picture_shown(frame->request.time);
    }
  });
  const auto show_cached = [this] {
    timeline_bar_->show_cached(views_->picture_cache(),
                               static_cast<int>(views_->active().projection()));
  };
  connect(&views_->picture_cache(), &PictureCache::changed, timeline_bar_, show_cached);
  connect(views_, &ViewGrid::active_changed, timeline_bar_, show_cached);
  addDockWidget(Qt::BottomDockWidgetArea, timeline_dock);
  auto* curves = new QDockWidget(tr("Curves"), this);
  curves->setObjectName("curves_dock");
  curves->setWidget(new CurvePanel(*timeline_, document_, this));
  addDockWidget(Qt::BottomDockWidgetArea, curves);
  splitDockWidget(curves, timeline_dock, Qt::Vertical);
  curves->hide();
  connect(timeline_bar_, &TimelineBar::refused, this, &MainWindow::show_status);
  connect(timeline_bar_, &TimelineBar::curves_asked_for, curves, [this, curves] {
    curves->setVisible(curves->isHidden());
    if (curves->isVisible()) resizeDocks({curves}, {240}, Qt::Vertical);
  });

  connect(&document_, &Document::object_changed, this, [this, lights, emitters, material] {
    const auto& object = document_.object();
    if (!object) return;
    const std::array panels{lights, emitters, material};  // by kind
    panels.at(static_cast<std::size_t>(object->kind))->raise();
  });
  connect(outliner, &Outliner::asked_for, this,
          [this, gaussians, group, lights, medium, material, emitters](Outliner::Kind kind,
                                                                       std::size_t index) {
            using Kind = Outliner::Kind;
            if (kind == Kind::spline) return tools_->activate("spline");
            if (kind == Kind::light) document_.set_active_light(index);
            QDockWidget* panel = kind == Kind::gaussians ? gaussians
                                 : kind == Kind::group   ? group
                                 : kind == Kind::medium  ? medium
                                 : kind == Kind::surface ? material
                                 : kind == Kind::emitter ? emitters
                                                         : lights;
            panel->show();
            panel->raise();
          });
}

}  // namespace brume
