#pragma once

class QAction;
class QMenu;

namespace brume {

class Document;
class ViewGrid;

// Adds View > Ground Grid. It comes on with a scene that has neither surfaces nor Gaussians and
// goes off with one that has; until then it stays as the user has set it.
QAction* add_ground_grid_action(QMenu& menu, Document& document, ViewGrid& views);

}  // namespace brume
