#pragma once

#include <QDockWidget>
#include <QStackedWidget>

#include "tests/app/test_window.h"

namespace brume {

// Shows the dock and the page that a widget is in.
inline void show_dock_of(QWidget& widget) {
  for (QWidget* above = &widget; !above->isWindow(); above = above->parentWidget()) {
    auto* pages = qobject_cast<QStackedWidget*>(above->parentWidget());
    pages ? pages->setCurrentWidget(above) : above->show();
    if (qobject_cast<QDockWidget*>(above)) above->raise();
  }
  QTRY_VERIFY(widget.isVisible());
}

}  // namespace brume
