#pragma once

#include <QList>

class QAction;
class QWidget;

namespace brume {

// Modeless help windows.
void show_about(QWidget* parent);
void show_keys(QWidget* parent, const QList<QAction*>& actions);

}  // namespace brume
