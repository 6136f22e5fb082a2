#include <QMenu>
#include <QSettings>

#include "app/panels/plots/performance_panel.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/rows.h"
#include "app/window/menus/menu_action.h"
#include "app/window/menus/menus.h"

namespace brume {
namespace {

constexpr const char* quality_key = "view/airlight";

struct Choice {
  const char* name;
  QString title;
  QString tool_tip;
  AirlightMethod method;
  int slices = Settings().slices;
};

QString auto_title(double max_error) {
  return QMenu::tr("&Auto (max error %1)").arg(bound_text(max_error));
}

std::vector<Choice> choices(double max_error) {
  return {{"auto", auto_title(max_error),
           QMenu::tr("The cheapest settings whose measured error stays below Performance > Max "
                     "error"),
           AirlightMethod::auto_},
          {"fast", QMenu::tr("&Fast"),
           QMenu::tr("Always %1 slices along each view ray, for heavy scenes and slow machines; "
                     "the error is still measured")
               .arg(FrameQuality::fast_slices),
           AirlightMethod::sliced, FrameQuality::fast_slices},
          {"sliced", QMenu::tr("Fi&xed (%1 slices)").arg(Settings().slices),
           QMenu::tr("Always the same settings: %1 slices along each view ray, with shadows in the "
                     "fog")
               .arg(Settings().slices),
           AirlightMethod::sliced},
          {"paper", QMenu::tr("&Paper's Method"),
           QMenu::tr("The approximation as published in 2007: light scattered once, without "
                     "shadows in the fog"),
           AirlightMethod::paper}};
}

}  // namespace

void fill_quality_menu(QMenu& menu, ViewGrid& views, PerformancePanel& performance) {
  auto* group = named(new QActionGroup(&menu), "airlight");
  menu.setToolTipsVisible(true);
  const auto add = [&](const QString& title, const QString& name, const QString& tool_tip,
                       bool is_chosen, auto choose) {
    return named(add_choice(group, title, is_chosen, choose), "airlight_" + name, tool_tip);
  };
  const QString remembered = QSettings().value(quality_key).toString();
  for (const Choice& choice : choices(performance.max_error())) {
    if (remembered == choice.name) views.set_airlight(choice.method, choice.slices);
  }
  const FrameQuality& quality = views.perspective().frames().quality();
  for (const Choice& choice : choices(performance.max_error())) {
    const auto is_current = [&quality, choice] {
      return quality.airlight() == choice.method &&
             (choice.method != AirlightMethod::sliced || quality.slices() == choice.slices);
    };
    const auto choose = [&views, choice] {
      views.set_airlight(choice.method, choice.slices);
      QSettings().setValue(quality_key, choice.name);
      FrameScheduler& frames = views.active().frames();
      if (frames.mode() == ViewMode::path_traced) frames.set_mode(ViewMode::final);
    };
    QAction* action = add(choice.title, choice.name, choice.tool_tip, is_current(), choose);
    // Another mode than the reference's gives way to what was chosen before.
    QObject::connect(&views, &ViewGrid::mode_changed, action, [action, is_current, &views] {
      const bool is_reference = views.active().frames().mode() == ViewMode::path_traced;
      if (!is_reference && is_current()) action->setChecked(true);
    });
    if (choice.method != AirlightMethod::auto_) continue;
    QObject::connect(&performance, &PerformancePanel::max_error_changed, action,
                     [action](double max_error) { action->setText(auto_title(max_error)); });
  }
  QAction* reference =
      add(QMenu::tr("&Reference (path traced)"), "reference",
          QMenu::tr("What all other settings are compared with: all orders of scattering by path "
                    "tracing, more and more exact in the background while nothing changes. The "
                    "active view only"),
          false, [&views] { views.active().frames().set_mode(ViewMode::path_traced); });
  QObject::connect(&views, &ViewGrid::mode_changed, reference, [reference, &views] {
    if (views.active().frames().mode() == ViewMode::path_traced) reference->setChecked(true);
  });
  menu.addActions(group->actions());
}

}  // namespace brume
