#include <QMenu>

#include "app/document/document.h"
#include "app/viewport/view_grid.h"
#include "app/window/menus/menus.h"

namespace brume {

QAction* add_ground_grid_action(QMenu& menu, Document& document, ViewGrid& views) {
  QAction* action = menu.addAction(ViewGrid::tr("&Ground Grid"));
  action->setObjectName("view.ground_grid");
  action->setToolTip(ViewGrid::tr(
      "A grid at y = 0, its lines 1, 2 or 5 times a power of ten of scene units apart"));
  action->setCheckable(true);
  QObject::connect(action, &QAction::toggled, &views, &ViewGrid::show_ground_grid);
  const auto follow = [action, &document] {
    action->setChecked(document.scene().surfaces.empty() && document.medium().empty());
  };
  on_change(document, Change::scene, action, follow);
  follow();
  return action;
}

}  // namespace brume
