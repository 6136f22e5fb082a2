#include "app/window/menus/fog_menu.h"

#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>

#include "app/document/document.h"
#include "app/viewport/view_grid.h"
#include "app/window/dialogs/fog_shape_dialog.h"
#include "app/window/menus/fog_place.h"

namespace brume {

void add_fog_menu(QMenuBar& bar, Document& document, ViewGrid& views) {
  const auto fog_text = [](const char* text) { return QCoreApplication::translate("Fog", text); };
  QMenu* menu = bar.addMenu(fog_text("F&og"));
  menu->setObjectName("fog_menu");
  menu->setToolTipsVisible(true);
  for (const FogPreset& preset : fog_presets()) {
    QAction* action = menu->addAction(fog_text(preset.title));
    action->setObjectName(preset.name);
    action->setToolTip(fog_text(preset.hint));
    QObject::connect(action, &QAction::triggered, &views, [&document, &views, &preset] {
      add_fog_preset(document, preset, fog_place(document, views.perspective()));
    });
  }
  menu->addSeparator();
  QAction* shape = menu->addAction(fog_text("Add S&hape…"));
  shape->setObjectName("fog.shape");
  shape->setToolTip(fog_text("A box, a sphere or height fog of Gaussians, by numbers"));
  QObject::connect(shape, &QAction::triggered, &views, [&document, &views] {
    auto* dialog =
        new FogShapeDialog(document, fog_place(document, views.perspective()), views.window());
    dialog->show();
  });
}

}  // namespace brume
