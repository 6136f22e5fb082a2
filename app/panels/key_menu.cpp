#include "app/panels/key_menu.h"

#include <QCoreApplication>
#include <QMenu>

#include "app/commands/edit_keys.h"
#include "app/document/keyframe_tracks.h"

namespace brume {

void show_key_menu(QWidget& owner, Document& document, const Track& row, double time,
                   const std::function<void()>& erase, const QPoint& global_position) {
  const auto menu_text = [](const char* text) {
    return QCoreApplication::translate("KeyMenu", text);
  };
  auto* menu = new QMenu(&owner);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, Interpolation interpolation) {
    menu->addAction(text, &owner, [&document, row, time, interpolation] {
      set_interpolation(document, row, time, interpolation);
    });
  };
  add(menu_text("&Smooth"), Interpolation::smooth);
  add(menu_text("&Linear"), Interpolation::linear);
  menu->addSeparator();
  menu->addAction(menu_text("&Delete"), &owner, erase);
  menu->popup(global_position);
}

}  // namespace brume
