#pragma once

#include <QByteArray>
#include <functional>

class QAction;
class QMainWindow;
class QMenu;
class QMenuBar;
class QString;

namespace brume {

class ColorManagement;
class Document;
class PerformancePanel;
class ViewGrid;

// The menu Fog: ready-made fog and shapes, added where the active view looks.
void add_fog_menu(QMenuBar& bar, Document& document, ViewGrid& views);

// A menu of the groups that the selection can be moved to.
void fill_group_menu(QMenu& menu, Document& document);

// Adds View > Overlays > Ground Grid. It comes on with a scene that has neither surfaces nor
// Gaussians and goes off with one that has; until then it stays as the user has set it.
QAction* add_ground_grid_action(QMenu& menu, Document& document, ViewGrid& views);

// Fills View > Quality: the method of all views, remembered; and the reference, which the active
// view shows as its mode Path Traced. `performance` has the bound of auto.
void fill_quality_menu(QMenu& menu, ViewGrid& views, PerformancePanel& performance);

// Fills the menu of view transforms, anew each time it opens: Brume's own, the displays and views
// of the configuration in use, ACES, and another configuration. `report` shows errors.
void fill_color_menu(QMenu& menu, ColorManagement& color,
                     const std::function<void(const QString&)>& report);

// Fills View > Layouts: where the panels of a window are, kept by name in the user's settings.
// `initial`: the state of the window that Reset restores.
void fill_layout_menu(QMenu& menu, QMainWindow& window, const QByteArray& initial);

}  // namespace brume
