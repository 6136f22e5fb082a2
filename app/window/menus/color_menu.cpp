#include <QMenu>
#include <optional>

#include "app/files/file_dialogs.h"
#include "app/frames/color_management.h"
#include "app/window/menus/menu_action.h"
#include "app/window/menus/menus.h"
#include "brume/error.h"

namespace brume {
namespace {

using Report = std::function<void(const QString&)>;

// Reports what is wrong with what `choose` makes the view of.
void choose_and_report(const ColorManagement& color, const Report& report,
                       const std::function<void()>& choose) {
  try {
    choose();
    if (!color.view()) return;
    for (const std::string& warning : color.view()->warnings()) {
      report(QString::fromStdString(warning));
    }
  } catch (const InputError& error) {
    report(QString::fromUtf8(error.what()));
  }
}

void add_view(QMenu& menu, QActionGroup& group, const QString& title, ColorManagement& color,
              const std::optional<ColorChoice>& choice, const Report& report) {
  const bool is_chosen = choice ? color.view() && color.view()->choice() == *choice : !color.view();
  QAction* action = add_choice(&group, title, is_chosen, [&color, choice, report] {
    choose_and_report(color, report, [&] { color.choose(choice); });
  });
  action->setParent(&menu);  // the search for commands finds it without the group, too
  menu.addAction(action);
}

void add_displays(QMenu& menu, QActionGroup& group, ColorManagement& color,
                  const std::string& config, const Report& report) {
  std::vector<ColorDisplay> displays;
  try {
    displays = color_displays(config);
  } catch (const InputError& error) {
    QAction* action = menu.addAction(QMenu::tr("The configuration cannot be read"));
    action->setToolTip(QString::fromUtf8(error.what()));
    action->setEnabled(false);
    return;
  }
  for (const ColorDisplay& display : displays) {
    menu.addSection(QString::fromStdString(display.name));
    for (const std::string& view : display.views) {
      add_view(menu, group, QString::fromStdString(view), color,
               ColorChoice{config, display.name, view}, report);
    }
  }
}

void fill(QMenu& menu, ColorManagement& color, const Report& report) {
  menu.clear();
  auto* group = new QActionGroup(&menu);
  QObject::connect(&menu, &QMenu::aboutToHide, group, &QObject::deleteLater);
  add_view(menu, *group, QMenu::tr("&Neutral"), color, std::nullopt, report);
  menu.actions().back()->setToolTip(
      QMenu::tr("Khronos PBR Neutral in sRGB: colours as they are, highlights compressed"));
  add_displays(menu, *group, color, color.config(), report);
  menu.addSeparator();
  if (color.config() != aces_config) {
    add_view(menu, *group, QMenu::tr("&ACES 1.0"), color, ColorView({aces_config, {}, {}}).choice(),
             report);
  }
  QAction* other = menu.addAction(QMenu::tr("&Configuration…"));
  other->setToolTip(QMenu::tr("Views of another configuration of OpenColorIO (.ocio)"));
  QObject::connect(other, &QAction::triggered, &menu, [&menu, &color, report] {
    const std::filesystem::path file =
        ask_for_file(menu.window(), FileKind::color, QMenu::tr("Choose a Configuration"),
                     QMenu::tr("OpenColorIO (*.ocio)"), {});
    if (file.empty()) return;
    choose_and_report(color, report, [&] { color.set_config(file.string()); });
  });
}

}  // namespace

void fill_color_menu(QMenu& menu, ColorManagement& color, const Report& report) {
  menu.setToolTipsVisible(true);
  QObject::connect(&menu, &QMenu::aboutToShow, &color,
                   [&menu, &color, report] { fill(menu, color, report); });
  fill(menu, color, report);
}

}  // namespace brume
