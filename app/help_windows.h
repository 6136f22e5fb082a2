#pragma once

#include <QList>

class QAction;
class QWidget;

namespace brume {

// Windows that stay open beside the work.
void show_about(QWidget* parent);
void show_keys(QWidget* parent, const QList<QAction*>& actions);

}  // namespace brume
