#pragma once

#include <QByteArray>

class QMainWindow;
class QMenu;

namespace brume {

// Fills View > Layouts: where the panels of a window are, kept by name in the user's settings.
// `initial`: the state of the window that Reset restores.
void fill_layout_menu(QMenu& menu, QMainWindow& window, const QByteArray& initial);

}  // namespace brume
