#include <QCoreApplication>
#include <QMenu>

#include "app/commands/gaussians/edit_groups.h"
#include "app/document/document.h"
#include "app/widgets/color_button.h"
#include "app/window/menus/menus.h"

namespace brume {

void fill_group_menu(QMenu& menu, Document& document) {
  menu.clear();
  const auto add = [&](const QString& text, GroupId group) {
    QAction* action = menu.addAction(
        text, &document, [&document, group] { move_selection_to_group(document, group); });
    action->setEnabled(!document.selection().empty());
    return action;
  };
  for (const Group& group : document.scene().groups) {
    QString name = QString::fromStdString(group.name);
    add(name.replace('&', "&&"), group.id)->setIcon(QIcon(color_swatch(group.color)));
  }
  menu.addSeparator();
  add(QCoreApplication::translate("brume::MainWindow", "Out of Groups"), 0);
}

}  // namespace brume
