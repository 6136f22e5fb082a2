#pragma once

#include <QMenu>
#include <functional>

namespace brume {

class ColorManagement;

// Fills the menu of view transforms, anew each time it opens: Brume's own, the displays and views
// of the configuration in use, ACES, and another configuration. `report` shows errors.
void fill_color_menu(QMenu& menu, ColorManagement& color,
                     const std::function<void(const QString&)>& report);

}  // namespace brume
